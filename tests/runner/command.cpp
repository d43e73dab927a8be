// Memory files and one call of the program.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include "runner/disk_files.h"

#include <sstream>

namespace trellis::test {

namespace {

class MemoryOutput : public OutputFile {
public:
    MemoryOutput(MemoryFiles& files, std::string path) : files_(files), path_(std::move(path)) {}
    bool write(std::string_view text) override {
        text_ += text;
        return true;
    }
    bool commit() override {
        if (files_.full.count(path_) != 0) { return false; }
        files_.content[path_] = text_;
        return true;
    }
    std::string why() const override { return "No space left on device"; }

private:
    MemoryFiles& files_;
    std::string path_;
    std::string text_;
};

class MemoryGrowing : public GrowingFile {
public:
    MemoryGrowing(MemoryFiles& files, std::string path) : files_(files), path_(std::move(path)) {}
    bool append(std::string_view record) override {
        std::string& text = files_.content[path_];
        const bool fits =
            files_.full.count(path_) == 0 || text.size() + record.size() <= files_.room;
        if (fits) { text += record; }
        return fits;
    }
    bool cut(std::size_t size) override {
        files_.content[path_].resize(size);
        return true;
    }
    std::string why() const override { return "No space left on device"; }

private:
    MemoryFiles& files_;
    std::string path_;
};

}  // namespace

std::optional<std::string> MemoryFiles::read(const std::string& path, std::size_t most,
                                             std::string& why) {
    why = refused.count(path) != 0 ? "Permission denied" : "No such file or directory";
    const auto at = content.find(path);
    if (at == content.end() || refused.count(path) != 0) { return {}; }
    why = "File too large";
    return at->second.size() > most ? std::nullopt : std::optional(at->second);
}

std::unique_ptr<OutputFile> MemoryFiles::create(const std::string& path, std::string& why) {
    why = "Permission denied";
    if (refused.count(path) != 0) { return nullptr; }
    return std::make_unique<MemoryOutput>(*this, path);
}

std::unique_ptr<GrowingFile> MemoryFiles::grow(const std::string& path, std::string& why) {
    why = "Permission denied";
    if (refused.count(path) != 0) { return nullptr; }
    content.try_emplace(path);
    return std::make_unique<MemoryGrowing>(*this, path);
}

Ran run_words(Files& files, const std::vector<std::string>& words, const std::string& in,
              const Terminal& terminal) {
    std::istringstream input(in);
    std::ostringstream out;
    std::ostringstream err;
    const Exit exit = run_program(words, {input, out, err, files}, terminal);
    return {exit, out.str(), err.str()};
}

Ran run_on_disk(const std::vector<std::string>& words) {
    DiskFiles files;
    return run_words(files, words);
}

std::string from_root(const std::string& path) {
    return std::string(TRELLIS_SOURCE_DIR) + '/' + path;
}

const char* const forward_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <MoveForward duration="0.05"/>
  </BehaviorTree>
</root>
)";

const char* const two_states =
    R"(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
  <state id="go">
    <onentry><log label="now" expr="'going'"/></onentry>
    <invoke type="leaf" src="SetVelocity"><param name="linear" expr="0.3"/></invoke>
    <transition event="tick" cond="elapsed() &gt; 0.04" target="done"/>
  </state>
  <final id="done"/>
</scxml>
)";

const char* const broken_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequenc>
      <MoveForward sped="1"/>
    </Sequenc>
  </BehaviorTree>
</root>
)";

}  // namespace trellis::test
