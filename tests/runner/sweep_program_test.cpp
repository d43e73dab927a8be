// trellis sweep as a process: killed and gone on with, on a disk that is full, several at once, as
// an MPI job; and the sweep files that come with Trellis.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "runner/shell.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace trellis::test;

namespace {

/// A folder with a sweep of 80 runs, removed at the end.
class Folder {
public:
    Folder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "trellis-sweep-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path = name;
        std::ofstream(path + "/s.json")
            << R"({"behaviours": [{"name": "lab", "file": ")" + from_root("machines/roomba.scxml") +
                   R"("}, {"name": "tree", "file": ")" + from_root("trees/roomba.xml") +
                   R"("}], "times": [30, 60], "seeds": {"count": 40}})";
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    /// Runs a command in it, $sweep being `trellis sweep s.json`.
    Shell operator()(const std::string& command) const {
        return shell("export trellis; cd " + path +
                     " && export sweep=\"$trellis sweep s.json\" && " + command);
    }
    std::string text(const std::string& name) const { return read_file(path + '/' + name); }

    std::string path;
};

}  // namespace

TEST_CASE("sweep program: 1 thread, 8 threads and 3 parts give the same bytes") {
    const Folder folder;
    CHECK(folder("$sweep --jobs 1 --out one.csv > one.txt").exit == 0);
    CHECK(folder("$sweep --jobs 8 --out eight.csv > eight.txt").exit == 0);
    CHECK(folder("for i in 1 2 3; do SLURM_ARRAY_TASK_ID=$i SLURM_ARRAY_TASK_COUNT=3 $sweep --out "
                 "p.csv >/dev/null || exit; done; $trellis sweep merge s.json p.csv.*.runs --out "
                 "three.csv > three.txt")
              .exit == 0);
    CHECK(folder.text("one.csv") == folder.text("eight.csv"));
    CHECK(folder.text("one.csv") == folder.text("three.csv"));
    CHECK(folder.text("one.txt") == folder.text("three.txt"));
}

#ifdef TRELLIS_MPI
TEST_CASE("sweep program: two ranks of an MPI job give the same bytes as one process") {
    const Folder folder;
    CHECK(folder("$sweep --out one.csv > one.txt").exit == 0);
    const Shell two = folder("mpirun --allow-run-as-root --oversubscribe -np 2 $sweep --out "
                             "two.csv > two.txt");
    CHECK(two.exit == 0);
    CHECK(folder.text("one.csv") == folder.text("two.csv"));
    CHECK(folder.text("one.txt") == folder.text("two.txt"));
    CHECK(folder("ls *.runs 2>/dev/null").out == "");
}
#endif

TEST_CASE("sweep program: killed again and again, it loses no run and doubles none") {
    const Folder folder;
    CHECK(folder("$sweep --out good.csv > good.txt").exit == 0);
    CHECK(folder("for i in 1 2 3 4 5 6; do timeout -s KILL 0.0$i $sweep --out rows.csv --resume "
                 ">/dev/null 2>&1; done; $sweep --out rows.csv --resume > rows.txt")
              .exit == 0);
    CHECK(folder.text("rows.csv") == folder.text("good.csv"));
    CHECK(folder.text("rows.txt") == folder.text("good.txt"));
    CHECK_FALSE(std::filesystem::exists(folder.path + "/rows.csv.runs"));
}

TEST_CASE("sweep program: what was done is not done again") {
    const Folder folder;
    // the file may grow to 16 blocks of 512 bytes: some runs fit, not all
    const Shell full = folder("(trap '' XFSZ; ulimit -f 16; $sweep --jobs 2 --out rows.csv 2>&1)");
    CHECK(full.exit == 3);
    CHECK(full.out == "trellis: cannot write \"rows.csv.runs\": File too large; what is done so "
                      "far is kept: go on with --resume\n");
    const std::string kept = folder.text("rows.csv.runs");
    CHECK(kept.size() > 4000);
    CHECK(kept.size() <= 8192);
    CHECK(kept.back() == '\n');
    const Shell again = folder("$sweep --out rows.csv 2>&1");
    CHECK(again.exit == 2);
    CHECK(folder.text("rows.csv.runs") == kept);

    // now the runs fit, but not the rows
    CHECK(folder("(trap '' XFSZ; ulimit -f 64; $sweep --out rows.csv --resume 2>&1)").exit == 3);
    CHECK(folder.text("rows.csv.runs").starts_with(kept));
    CHECK(folder("$sweep --out rows.csv --resume >/dev/null && $sweep --out good.csv >/dev/null")
              .exit == 0);
    CHECK(folder.text("rows.csv") == folder.text("good.csv"));
}

TEST_CASE("sweep program: paths that cannot be written") {
    const Folder folder;
    const Shell none = folder("$sweep --out none/rows.csv 2>&1");
    CHECK(none.exit == 3);
    CHECK(none.out == "trellis: cannot write \"none/rows.csv.runs\": No such file or directory\n");
    CHECK(folder("$sweep --out - 2>&1 >/dev/full").exit == 3);
}

TEST_CASE("sweep program: only one process at a time works on a file") {
    const Folder folder;
    const Shell busy = folder("flock rows.csv.runs -c '$sweep --out rows.csv --resume 2>&1'");
    CHECK(busy.exit == 3);
    CHECK(busy.out == "trellis: cannot write \"rows.csv.runs\": another process is writing it\n");
}

TEST_CASE("sweep program: the sweep files that come with Trellis run") {
    const Folder folder;
    const std::string root = from_root("");
    REQUIRE(folder("mkdir sweeps && ln -s " + root + "trees " + root + "machines " + root + "sim .")
                .exit == 0);
    for (const auto& file : files_below("sweeps", {".json"})) {
        CAPTURE(file.string());
        // shorter, and fewer
        const Shell ran = folder("sed -E 's/\"count\": [0-9]+/\"count\": 1/; s/\"times\": "
                                 "\\[.*\\]/\"times\": [2]/' " +
                                 from_root(file.string()) +
                                 " > sweeps/s.json && $trellis sweep sweeps/s.json 2>&1");
        CHECK_MESSAGE(ran.exit == 0, ran.out);
        CHECK(ran.out.starts_with("after 2 s, seeds 0 to 0\n"));
    }
}
