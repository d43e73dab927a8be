// Files and pipes under one name, and messages with and without colour.
// SPDX-License-Identifier: MIT
#include "runner/streams.h"

#include "load/diagnostics.h"

#include <istream>
#include <iterator>
#include <ostream>

namespace trellis {

namespace {

/// Standard output as a file. That nobody reads it any more is for main.cpp to find and say.
class PipeOutput : public OutputFile {
public:
    explicit PipeOutput(std::ostream& out) : out_(out) {}
    bool write(std::string_view text) override { return static_cast<bool>(out_ << text); }
    bool commit() override { return static_cast<bool>(out_.flush()); }
    std::string why() const override { return {}; }

private:
    std::ostream& out_;
};

constexpr std::string_view plain = "\x1b[0m";
constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view red = "\x1b[1;31m";
constexpr std::string_view magenta = "\x1b[1;35m";
constexpr std::string_view green = "\x1b[1;32m";

std::string painted(std::string_view colour, std::string_view text) {
    return std::string(colour) + std::string(text) + std::string(plain);
}

/// A rendered finding: the place bold, the severity red or magenta, the caret green.
std::string painted(const Diagnostics& diagnostics, const Diagnostic& d) {
    const std::string text = diagnostics.render(d);
    const bool error = d.severity == Diagnostic::Severity::error;
    const std::string_view word = error ? "error: " : "warning: ";
    const std::size_t at = text.find(word, diagnostics.file_name(d.where.file).size());
    std::string out = at == 0 ? "" : painted(bold, text.substr(0, at));
    out += painted(error ? red : magenta, word);
    const std::size_t caret = text.find_last_not_of(" \n^");
    const std::size_t last_line = text.find('\n', caret) + 1;
    const std::size_t rest = at + word.size();
    if (last_line == text.size()) { return out + text.substr(rest); }
    out += text.substr(rest, last_line - rest);
    const std::string_view below = std::string_view(text).substr(last_line);
    return out + painted(green, below.substr(0, below.size() - 1)) + '\n';
}

}  // namespace

std::optional<std::string> read_text(const std::string& path, Streams& streams, std::size_t most) {
    if (path == "-") {
        std::string text;
        std::istreambuf_iterator<char> in(streams.in);
        for (; in != std::istreambuf_iterator<char>() && text.size() <= most; ++in) {
            text += *in;
        }
        if (!streams.in.bad() && text.size() <= most) { return text; }
        complain(streams, Exit::file,
                 streams.in.bad() ? "cannot read standard input"
                                  : "cannot read standard input: File too large");
        return {};
    }
    std::string why;
    std::optional<std::string> text = streams.files.read(path, most, why);
    if (!text) { complain(streams, Exit::file, "cannot read \"" + path + "\": " + why); }
    return text;
}

std::unique_ptr<OutputFile> open_output(const std::string& path, Streams& streams) {
    if (path == "-") { return std::make_unique<PipeOutput>(streams.out); }
    std::string why;
    std::unique_ptr<OutputFile> file = streams.files.create(path, why);
    if (!file) { complain(streams, Exit::file, "cannot write \"" + path + "\": " + why); }
    return file;
}

bool commit(OutputFile& file, const std::string& path, Streams& streams) {
    if (file.commit()) { return true; }
    if (path != "-") {
        complain(streams, Exit::file, "cannot write \"" + path + "\": " + file.why());
    }
    return false;
}

bool write_text(const std::string& path, std::string_view text, Streams& streams) {
    const std::unique_ptr<OutputFile> file = open_output(path, streams);
    if (!file) { return false; }
    // a write that fails makes the commit fail as well
    file->write(text);
    return commit(*file, path, streams);
}

Exit complain(Streams& streams, Exit exit, std::string_view message) {
    streams.err << "trellis: " << message << '\n';
    return exit;
}

void show(const Diagnostics& diagnostics, Streams& streams) {
    const std::string all = diagnostics.render();
    if (!streams.colour) {
        streams.err << all;
        return;
    }
    for (const Diagnostic& d : diagnostics.all()) {
        streams.err << painted(diagnostics, d);
    }
    // the line that counts
    if (!all.empty()) { streams.err << all.substr(all.rfind('\n', all.size() - 2) + 1); }
}

}  // namespace trellis
