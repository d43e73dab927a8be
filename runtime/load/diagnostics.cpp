// Collecting, ordering and rendering findings, and guessing what a misspelt name was meant to be.
// Covered by tests/load/diagnostics_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/diagnostics.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

namespace trellis {

namespace {

/// Bytes of a line that are shown; a longer line is cut around the place.
constexpr std::size_t shown_bytes = 120;
/// Lines from one whose place is kept to the next: a text may have nothing but line feeds.
constexpr std::size_t lines_per_mark = 64;
/// Bytes shown in front of the place when the line is cut.
constexpr std::size_t shown_before = 60;
/// Longer names are not compared: the distance takes time proportional to both lengths.
constexpr std::size_t longest_compared = 64;

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::string counted(std::size_t n, std::string_view what) {
    std::string out = std::to_string(n) + " ";
    out += what;
    if (n != 1) { out += 's'; }
    return out;
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The line and, below it, the caret under byte `column` (from 0).
std::string excerpt(std::string_view line, std::size_t column) {
    column = std::min(column, line.size());
    std::size_t begin = 0;
    std::size_t end = line.size();
    if (line.size() > shown_bytes) {
        begin = column > shown_before ? column - shown_before : 0;
        begin = std::min(begin, line.size() - shown_bytes);
        end = begin + shown_bytes;
        while (begin > 0 && continues_character(line[begin])) {
            --begin;
        }
        while (end < line.size() && continues_character(line[end])) {
            ++end;
        }
    }

    std::string shown;
    std::string caret;
    if (begin > 0) {
        shown += "…";
        caret += ' ';
    }
    shown += line.substr(begin, end - begin);
    if (end < line.size()) { shown += "…"; }
    // a tab stays a tab and a character of several bytes takes one column, so the caret lines up
    for (std::size_t i = begin; i < column; ++i) {
        if (!continues_character(line[i])) { caret += line[i] == '\t' ? '\t' : ' '; }
    }
    return shown + "\n" + caret + "^\n";
}

/// Half edits between two names: a change of letter case costs one, everything else two. The
/// optimal-string-alignment form of Damerau and Levenshtein's distance, on three rows.
std::size_t half_edits(std::string_view a, std::string_view b) {
    using Row = std::array<std::size_t, longest_compared + 1>;
    Row before_last{};
    Row last{};
    Row row{};
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = 2 * j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = 2 * i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = a[i - 1];
            const char y = b[j - 1];
            const std::size_t change = x == y ? 0 : lower(x) == lower(y) ? 1 : 2;
            row[j] = std::min({last[j] + 2, row[j - 1] + 2, last[j - 1] + change});
            if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
                row[j] = std::min(row[j], before_last[j - 2] + 2);
            }
        }
        before_last = last;
        last = row;
    }
    return last[b.size()];
}

auto place(const Diagnostic& d) {
    return std::tie(d.where.file, d.where.line, d.where.column);
}

}  // namespace

std::uint32_t Diagnostics::take_file(std::string name, std::string text) {
    File file{std::move(name), std::move(text), {0}};
    std::size_t line = 1;
    const char* const begin = file.text.data();
    const char* const end = begin + file.text.size();
    for (const char* at = begin; at != end; ++at) {
        at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
        if (at == nullptr) { break; }
        if (++line % lines_per_mark == 1) {
            file.marks.push_back(static_cast<std::size_t>(at - begin) + 1);
        }
    }
    files_.push_back(std::move(file));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

void Diagnostics::add(Diagnostic::Severity severity, bool structural, std::string id, Where where,
                      std::string message) {
    const bool error = severity == Diagnostic::Severity::error;
    const std::size_t count = ++(error ? errors_ : warnings_);
    if (count > most + 1) { return; }
    if (count == most + 1) {
        structural = false;
        id = "too-many";
        message = "more than " + std::to_string(most) + (error ? " errors" : " warnings") +
                  ": this one and all after it are not shown";
    }
    all_.push_back({severity, structural, std::move(id), where, std::move(message)});
}

void Diagnostics::error(std::string id, Where where, std::string message) {
    add(Diagnostic::Severity::error, false, std::move(id), where, std::move(message));
}

void Diagnostics::structural_error(std::string id, Where where, std::string message) {
    add(Diagnostic::Severity::error, true, std::move(id), where, std::move(message));
}

void Diagnostics::warning(std::string id, Where where, std::string message) {
    add(Diagnostic::Severity::warning, false, std::move(id), where, std::move(message));
}

bool Diagnostics::structural() const {
    return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.structural; });
}

std::string_view Diagnostics::file_name(std::uint32_t file) const {
    return file < files_.size() ? std::string_view(files_[file].name) : std::string_view();
}

std::string_view Diagnostics::file_text(std::uint32_t file) const {
    return file < files_.size() ? std::string_view(files_[file].text) : std::string_view();
}

void Diagnostics::sort() {
    std::stable_sort(all_.begin(), all_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
    // repetitions are neighbours once each place is ordered by content; `order` keeps the first
    const auto content = [this](std::size_t i) {
        const Diagnostic& d = all_[i];
        return std::tie(d.where.file, d.where.line, d.where.column, d.severity, d.structural, d.id,
                        d.message);
    };
    std::vector<std::size_t> order(all_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return content(a) < content(b); });
    const auto last = std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return content(a) == content(b);
    });
    order.erase(last, order.end());
    std::sort(order.begin(), order.end());

    std::vector<Diagnostic> kept;
    kept.reserve(order.size());
    for (const std::size_t i : order) {
        kept.push_back(std::move(all_[i]));
    }
    all_ = std::move(kept);
    errors_ =
        static_cast<std::size_t>(std::count_if(all_.begin(), all_.end(), [](const Diagnostic& d) {
            return d.severity == Diagnostic::Severity::error;
        }));
}

std::string Diagnostics::render(const Diagnostic& d) const {
    std::string out(file_name(d.where.file));
    if (!out.empty()) { out += ':'; }
    if (d.where.line != 0) {
        out += std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + ":";
    }
    if (!out.empty()) { out += ' '; }
    out += d.severity == Diagnostic::Severity::error ? "error: " : "warning: ";
    out += d.message + " [" + d.id + "]\n";

    if (d.where.file >= files_.size() || d.where.line == 0) { return out; }
    const File& file = files_[d.where.file];
    const std::size_t mark = (d.where.line - 1) / lines_per_mark;
    if (mark >= file.marks.size()) { return out; }
    std::size_t begin = file.marks[mark];
    for (std::size_t n = (d.where.line - 1) % lines_per_mark; n > 0; --n) {
        begin = file.text.find('\n', begin) + 1;
        if (begin == 0) { return out; }
    }
    // what stands far behind the place is not shown: the rest of the file may be one line
    const std::size_t column = d.where.column == 0 ? 0 : d.where.column - 1;
    std::string_view line = std::string_view(file.text).substr(begin, column + 2 * shown_bytes);
    line = line.substr(0, line.find('\n', line.size() > column ? column : 0));
    if (line.ends_with('\r')) { line.remove_suffix(1); }
    return out + excerpt(line, column);
}

std::string Diagnostics::render() const {
    std::string out;
    for (const Diagnostic& d : all_) {
        out += render(d);
    }
    const std::size_t warnings = all_.size() - errors_;
    if (errors_ != 0) { out += counted(errors_, "error"); }
    if (errors_ != 0 && warnings != 0) { out += ", "; }
    if (warnings != 0) { out += counted(warnings, "warning"); }
    if (!all_.empty()) { out += '\n'; }
    return out;
}

std::string_view closest(std::string_view wrong, const std::vector<std::string_view>& candidates) {
    if (wrong.size() > longest_compared) { return {}; }
    // a third of the length, in half edits
    std::size_t best = 2 * wrong.size() / 3 + 1;
    std::string_view found;
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > longest_compared) { continue; }
        const std::size_t longer = std::max(wrong.size(), candidate.size());
        const std::size_t shorter = std::min(wrong.size(), candidate.size());
        if (2 * (longer - shorter) >= best) { continue; }
        const std::size_t edits = half_edits(wrong, candidate);
        if (edits < best) {
            best = edits;
            found = candidate;
        }
    }
    return found;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& candidates) {
    const std::string_view meant = closest(wrong, candidates);
    if (meant.empty()) { return {}; }
    return "; did you mean \"" + std::string(meant) + "\"?";
}

}  // namespace trellis
