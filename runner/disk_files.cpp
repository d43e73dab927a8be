// Reading whole files, and writing them whole or not at all.
// SPDX-License-Identifier: MIT
#include "runner/disk_files.h"

#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace trellis {

namespace {

/// Writes all of `text`; false, and errno, if that fails.
bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(file, text.data(), text.size());
        if (n < 0 && errno == EINTR) { continue; }
        if (n < 0) { return false; }
        text.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

/// A file descriptor that is written to through a buffer. With a `temporary` name it is renamed to
/// `path` at the end.
class DiskOutput : public OutputFile {
public:
    DiskOutput(int file, std::string temporary, std::string path)
        : file_(file), temporary_(std::move(temporary)), path_(std::move(path)) {}
    ~DiskOutput() override {
        if (file_ >= 0) { ::close(file_); }
        if (!temporary_.empty()) { ::unlink(temporary_.c_str()); }
    }
    DiskOutput(const DiskOutput&) = delete;
    DiskOutput& operator=(const DiskOutput&) = delete;

    bool write(std::string_view text) override {
        buffer_ += text;
        return buffer_.size() < buffer_size || flush();
    }

    bool commit() override {
        const bool closed = flush() && ::close(std::exchange(file_, -1)) == 0;
        if (!closed || (!temporary_.empty() && ::rename(temporary_.c_str(), path_.c_str()) != 0)) {
            if (error_ == 0) { error_ = errno; }
            return false;
        }
        temporary_.clear();
        return true;
    }

    std::string why() const override { return std::strerror(error_); }

private:
    static constexpr std::size_t buffer_size = 1 << 16;

    bool flush() {
        if (error_ == 0 && !write_all(file_, buffer_)) { error_ = errno; }
        buffer_.clear();
        return error_ == 0;
    }

    int file_;
    std::string temporary_;  // empty: none, or already renamed
    std::string path_;
    std::string buffer_;
    int error_ = 0;  // errno of the first failure
};

/// A locked file descriptor whose end is written to.
class DiskGrowing : public GrowingFile {
public:
    explicit DiskGrowing(int file) : file_(file), size_(::lseek(file, 0, SEEK_END)) {}
    ~DiskGrowing() override { ::close(file_); }
    DiskGrowing(const DiskGrowing&) = delete;
    DiskGrowing& operator=(const DiskGrowing&) = delete;

    bool append(std::string_view record) override {
        if (!write_all(file_, record)) {
            error_ = errno;
            // part of it may have been written: a record is whole or not there
            return back_to(size_) && false;
        }
        size_ += static_cast<off_t>(record.size());
        return true;
    }

    bool cut(std::size_t size) override { return back_to(static_cast<off_t>(size)); }

    std::string why() const override { return std::strerror(error_); }

private:
    bool back_to(off_t size) {
        const bool done = ::ftruncate(file_, size) == 0 && ::lseek(file_, size, SEEK_SET) == size;
        if (done) {
            size_ = size;
        } else {
            error_ = errno;
        }
        return done;
    }

    int file_;
    off_t size_;
    int error_ = 0;  // errno of the last failure
};

/// The rights that a new file gets: those of open(), which mkstemp() does not give.
mode_t default_rights() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

std::unique_ptr<OutputFile> open_directly(const std::string& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) { return nullptr; }
    return std::make_unique<DiskOutput>(file, "", path);
}

/// Makes a temporary file beside `path`; null and errno if that fails.
std::unique_ptr<OutputFile> open_beside(const std::string& path, mode_t rights) {
    std::string temporary = path + ".XXXXXX";
    const int file = ::mkostemp(temporary.data(), O_CLOEXEC);
    if (file < 0) { return nullptr; }
    auto output = std::make_unique<DiskOutput>(file, temporary, path);
    if (::fchmod(file, rights) != 0) { return nullptr; }
    return output;
}

std::unique_ptr<OutputFile> open_file(const std::string& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) {
        return errno == ENOENT ? open_beside(path, default_rights()) : nullptr;
    }
    if (S_ISDIR(info.st_mode)) {
        errno = EISDIR;
        return nullptr;
    }
    if (!S_ISREG(info.st_mode)) { return open_directly(path); }
    // renaming asks the folder for permission, not the file
    if (::access(path.c_str(), W_OK) != 0) { return nullptr; }
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    return open_beside(error ? path : real.string(), info.st_mode & 07777);
}

}  // namespace

std::optional<std::string> DiskFiles::read(const std::string& path, std::size_t most,
                                           std::string& why) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::string text;
    ssize_t n = -1;
    if (file >= 0) {
        // room at once, for a regular file; others say that they are empty
        struct stat info {};
        if (::fstat(file, &info) == 0 && info.st_size > 0) {
            text.reserve(std::min(static_cast<std::size_t>(info.st_size), most));
        }
        std::array<char, 1 << 16> buffer;
        while ((n = ::read(file, buffer.data(), buffer.size())) > 0 || (n < 0 && errno == EINTR)) {
            if (n > 0 && static_cast<std::size_t>(n) > most - text.size()) {
                errno = EFBIG;
                n = -1;
                break;
            }
            if (n > 0) { text.append(buffer.data(), static_cast<std::size_t>(n)); }
        }
    }
    if (n < 0) { why = std::strerror(errno); }
    if (file >= 0) { ::close(file); }
    return n < 0 ? std::nullopt : std::optional(std::move(text));
}

std::unique_ptr<OutputFile> DiskFiles::create(const std::string& path, std::string& why) {
    std::unique_ptr<OutputFile> output = open_file(path);
    if (!output) { why = std::strerror(errno); }
    return output;
}

std::unique_ptr<GrowingFile> DiskFiles::grow(const std::string& path, std::string& why) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) != 0) {
        why = errno == EWOULDBLOCK ? "another process is writing it" : std::strerror(errno);
        if (file >= 0) { ::close(file); }
        return nullptr;
    }
    return std::make_unique<DiskGrowing>(file);
}

void DiskFiles::remove(const std::string& path) {
    ::unlink(path.c_str());
}

}  // namespace trellis
