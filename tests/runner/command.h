// Runs commands of the program in a test, without a process or a disk. Covered by every test here.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/command_line.h"
#include "runner/streams.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace trellis::test {

/// Files in memory. Paths in `refused` exist but can be neither read nor written; writing to a path
/// in `full` fails when it is committed, and adding to it when it would have more than `room`
/// bytes.
class MemoryFiles : public Files {
public:
    std::map<std::string, std::string> content;
    std::set<std::string> refused;
    std::set<std::string> full;
    std::size_t room = 0;

    std::optional<std::string> read(const std::string& path, std::size_t most,
                                    std::string& why) override;
    std::unique_ptr<OutputFile> create(const std::string& path, std::string& why) override;
    std::unique_ptr<GrowingFile> grow(const std::string& path, std::string& why) override;
    void remove(const std::string& path) override { content.erase(path); }
};

/// What a command did.
struct Ran {
    Exit exit = Exit::internal;
    std::string out, err;
};

/// `trellis` with these words.
Ran run_words(Files& files, const std::vector<std::string>& words, const std::string& in = {},
              const Terminal& terminal = {});

/// The same on the disk, for files of the repository: paths are made absolute by from_root().
Ran run_on_disk(const std::vector<std::string>& words);
std::string from_root(const std::string& path);

/// Files that several tests use.
extern const char* const forward_tree;  ///< one leaf: MoveForward for 0.05 s
extern const char* const two_states;    ///< "go" for 0.05 s, then the final state "done"
extern const char* const broken_tree;   ///< two errors

}  // namespace trellis::test
