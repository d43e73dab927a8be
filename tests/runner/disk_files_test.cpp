// Files on the disk: whole or not at all.
// SPDX-License-Identifier: MIT
#include "runner/disk_files.h"

#include "support/files.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace trellis;
namespace fs = std::filesystem;

namespace {

/// A new folder that is removed at the end.
struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "trellis-files-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path = name;
    }
    ~Folder() { fs::remove_all(path); }
    std::string operator/(const char* name) const { return (path / name).string(); }
    std::size_t size() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

}  // namespace

TEST_CASE("disk files: what was written is read again") {
    const Folder folder;
    DiskFiles files;
    std::string why;
    const std::string text(200'000, 'x');
    const auto file = files.create(folder / "a", why);
    REQUIRE(file);
    CHECK(file->write(text));
    CHECK(file->write("end"));
    CHECK_FALSE(fs::exists(folder / "a"));
    CHECK(file->commit());
    CHECK(files.read(folder / "a", std::string::npos, why) == text + "end");
    CHECK(files.read(folder / "a", text.size() + 3, why) == text + "end");
    CHECK_FALSE(files.read(folder / "a", text.size() + 2, why));
    CHECK(why == "File too large");
    CHECK(folder.size() == 1);
}

TEST_CASE("disk files: a file that is not committed leaves nothing and keeps what was there") {
    const Folder folder;
    std::ofstream(folder / "old") << "old";
    DiskFiles files;
    std::string why;
    files.create(folder / "new", why)->write("new");
    files.create(folder / "old", why)->write("new");
    CHECK(folder.size() == 1);
    CHECK(files.read(folder / "old", std::string::npos, why) == "old");
}

TEST_CASE("disk files: a file that is replaced keeps its rights, and links keep pointing to it") {
    const Folder folder;
    std::ofstream(folder / "real") << "old";
    REQUIRE(::chmod((folder / "real").c_str(), 0640) == 0);
    fs::create_symlink("real", folder / "link");
    DiskFiles files;
    std::string why;
    const auto file = files.create(folder / "link", why);
    REQUIRE(file);
    file->write("new");
    REQUIRE(file->commit());
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(files.read(folder / "real", std::string::npos, why) == "new");
    CHECK(static_cast<int>(fs::status(folder / "real").permissions()) == 0640);
}

TEST_CASE("disk files: the system says why something cannot be done") {
    const Folder folder;
    DiskFiles files;
    std::string why;
    CHECK_FALSE(files.read(folder / "a", std::string::npos, why));
    CHECK(why == "No such file or directory");
    CHECK_FALSE(files.read(folder.path.string(), std::string::npos, why));
    CHECK(why == "Is a directory");
    CHECK(files.create(folder.path.string(), why) == nullptr);
    CHECK(why == "Is a directory");
    CHECK(files.create(folder / "no/folder", why) == nullptr);
    CHECK(why == "No such file or directory");
    const auto full = files.create("/dev/full", why);
    REQUIRE(full);
    full->write("x");
    CHECK_FALSE(full->commit());
    CHECK(full->why() == "No space left on device");
}
