// JSON as text.
// SPDX-License-Identifier: MIT
#include "runner/json_writer.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <utility>

using namespace trellis;

TEST_CASE("json writer: objects and arrays, indented") {
    JsonWriter json;
    json.begin_object().text("name", "a").number("x", 3.2).integer("seed", -7).count("n", 2);
    json.boolean("ok", true).null("none").begin_array("list").element("b").count({}, 1);
    json.end_array().begin_array("empty").end_array().end_object();
    CHECK(std::move(json).finish() == "{\n"
                                      "  \"name\": \"a\",\n"
                                      "  \"x\": 3.2,\n"
                                      "  \"seed\": -7,\n"
                                      "  \"n\": 2,\n"
                                      "  \"ok\": true,\n"
                                      "  \"none\": null,\n"
                                      "  \"list\": [\n"
                                      "    \"b\",\n"
                                      "    1\n"
                                      "  ],\n"
                                      "  \"empty\": []\n"
                                      "}\n");
}

TEST_CASE("json writer: on one line, and numbers that JSON does not have") {
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().number("a", std::numeric_limits<double>::infinity());
    json.begin_array("b").number({}, 1.0).number({}, 2.5).end_array().end_object();
    CHECK(std::move(json).finish() == "{\"a\": null, \"b\": [1.0, 2.5]}\n");
}

TEST_CASE("json writer: every string is JSON, and reads back as it was") {
    const std::string odd("a\"\\\n\t\r\x01/\xC3\xA9\xF0\x9F\xA4\x96", 15);
    std::string out;
    append_json_string(out, odd);
    CHECK(nlohmann::json::parse(out).get<std::string>() == odd);
    for (const char* wrong : {"\xFF", "\xC3", "\xC0\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80"}) {
        out.clear();
        append_json_string(out, wrong);
        CHECK(nlohmann::json::accept(out));
        CHECK(out.find("\xEF\xBF\xBD") == 1);
    }
}
