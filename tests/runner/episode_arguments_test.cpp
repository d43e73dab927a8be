// The options of an episode.
// SPDX-License-Identifier: MIT
#include "runner/episode_arguments.h"

#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("episode arguments: a time is so many whole ticks") {
    EpisodeArguments arguments;
    CHECK(arguments.tick_count() == 3600);
    arguments.time = 0.1;
    CHECK(arguments.tick_count() == 6);
    arguments.dt = 0.05;
    CHECK(arguments.tick_count() == 2);
    arguments.time = 1e300;
    CHECK(arguments.tick_count() == 1'000'000'000'000);
    arguments.ticks = 7;
    CHECK(arguments.tick_count() == 7);
}

TEST_CASE("episode arguments: the pose and the tick that are asked for are used") {
    MemoryFiles files;
    files.content = {{"a.xml", forward_tree}};
    const Ran ran = run_words(files, {"run", "a.xml", "--pose", "-1,2.5,0", "--dt", "0.5", "--time",
                                      "0.5", "--trace", "-"});
    CHECK(ran.out == "tick,t,x,y,rotation,v,w,bumper,leaf\n"
                     "0,0.0,-1.0,2.5,0.0,0.0,0.0,0,-\n"
                     "1,0.5,0.42000000000000004,2.5,0.0,0.5,0.0,1,MoveForward\n");
    CHECK(ran.err.find("1 tick of 0.5 s") != std::string::npos);
}

TEST_CASE("episode arguments: wrong values are usage errors") {
    MemoryFiles files;
    files.content = {{"a.xml", forward_tree}};
    const auto message = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"run", "a.xml"});
        const Ran ran = run_words(files, words);
        CHECK(ran.exit == Exit::usage);
        CHECK(ran.out == "");
        return ran.err.substr(0, ran.err.find('\n'));
    };
    CHECK(message({"--pose", "1,2"}) ==
          "trellis: --pose: expected three numbers as in 3.2,2.4,0, found \"1,2\"");
    CHECK(message({"--pose", "1,2,3,4"}) ==
          "trellis: --pose: expected three numbers as in 3.2,2.4,0, found \"1,2,3,4\"");
    CHECK(message({"--time", "0"}) ==
          "trellis: --time: expected a number of seconds above 0, found \"0\"");
    CHECK(message({"--dt", "nan"}) ==
          "trellis: --dt: expected a number of seconds above 0, found \"nan\"");
    CHECK(message({"--time", "1", "--ticks", "3"}) == "trellis: --ticks excludes --time");
    CHECK(message({"--draws", "f", "--seed", "3"}) == "trellis: --draws excludes --seed");
}

TEST_CASE("episode arguments: faulty draws stop the run, with every fault") {
    MemoryFiles files;
    files.content = {{"a.xml", forward_tree}, {"draws.txt", "one\ntwo\n"}};
    const Ran ran = run_words(files, {"run", "a.xml", "--draws", "draws.txt"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "");
    CHECK(ran.err.ends_with("2 errors\n"));
    CHECK(run_words(files, {"run", "a.xml", "--draws", "none.txt"}).exit == Exit::file);
}
