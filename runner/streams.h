// What a command reads and writes: standard input, output and error, and files, as values, so that
// tests run commands without a process or a disk. The real ones are made in main.cpp and
// disk_files.h. Covered by tests/runner/streams_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

class Diagnostics;

/// How a command ended: the exit code of the program.
enum class Exit : int {
    yes = 0,       ///< done; the answer is yes
    no = 1,        ///< the answer is no: an invalid file, a difference, a behaviour that failed
    usage = 2,     ///< the command line makes no sense
    file = 3,      ///< something cannot be read or written
    internal = 4,  ///< a defect of this program
};

/// A file that is being written. It appears under its name, whole, when it is committed; one that
/// is destroyed before leaves nothing behind.
class OutputFile {
public:
    virtual ~OutputFile() = default;
    /// False if it failed; why() then says why.
    virtual bool write(std::string_view text) = 0;
    virtual bool commit() = 0;
    virtual std::string why() const = 0;
};

/// A file that grows by whole records, which others see at once and a killed process leaves behind.
/// Nobody else can have it open in this way.
class GrowingFile {
public:
    virtual ~GrowingFile() = default;
    /// Adds `record`, or nothing at all: then false, and why() says why.
    virtual bool append(std::string_view record) = 0;
    /// Keeps only the first `size` bytes.
    virtual bool cut(std::size_t size) = 0;
    virtual std::string why() const = 0;
};

/// Where files come from and go to.
class Files {
public:
    virtual ~Files() = default;
    /// The content of a file, or none and the reason in `why`: "No such file or directory", or
    /// "File too large" if it has more than `most` bytes.
    virtual std::optional<std::string> read(const std::string& path, std::size_t most,
                                            std::string& why) = 0;
    /// A new file; null, and the reason in `why`, if it cannot be made.
    virtual std::unique_ptr<OutputFile> create(const std::string& path, std::string& why) = 0;
    /// A file to add to, new if there is none; null, and the reason in `why`, if it cannot be
    /// opened or somebody else has it open.
    virtual std::unique_ptr<GrowingFile> grow(const std::string& path, std::string& why) = 0;
    virtual void remove(const std::string& path) = 0;
};

struct Streams {
    std::istream& in;
    std::ostream& out;  ///< the result and nothing else
    std::ostream& err;  ///< messages
    Files& files;
    bool colour = false;    ///< of messages
    bool prompt = false;    ///< someone types standard input
    bool progress = false;  ///< someone watches standard error: a terminal
    /// The value of an environment variable, or null; none are set where it is null itself.
    const char* (*environment)(const char* name) = nullptr;
};

/// The content of the file, or of standard input for "-"; none after a message.
/// Files of more than `most` bytes are not read.
std::optional<std::string> read_text(const std::string& path, Streams& streams,
                                     std::size_t most = std::string::npos);

/// Opens a file, or standard output for "-"; null after a message.
std::unique_ptr<OutputFile> open_output(const std::string& path, Streams& streams);

/// commit(), with a message if it fails.
bool commit(OutputFile& file, const std::string& path, Streams& streams);

/// Writes a whole file, or standard output for "-"; false after a message.
bool write_text(const std::string& path, std::string_view text, Streams& streams);

/// "trellis: " and the message, on standard error. Returns `exit`: return complain(…).
Exit complain(Streams& streams, Exit exit, std::string_view message);

/// All findings and their number, on standard error, in colour if `streams` says so.
void show(const Diagnostics& diagnostics, Streams& streams);

}  // namespace trellis
