// Python's random numbers, bit for bit: `Random(7).uniform(a, b)` is `random.Random(7).uniform(a,
// b)` of CPython 3, so that a run can be checked against the standard library of Python. Or the
// replay of a list of recorded numbers. A regular value: it lies in the State, is copied, compared
// and saved with it. Not for secrets. Covered by tests/core/random_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trellis {

class Random {
public:
    /// Neither seeded nor replaying: draws are 0 and exhausted() is true at once. No memory is
    /// held.
    Random() = default;

    /// The Mersenne Twister MT19937, seeded as CPython seeds it with the integer |seed|.
    explicit Random(std::int64_t seed);

    /// Each draw, of whatever distribution, is the next of `draws`.
    static Random replaying(std::vector<double> draws);

    double uniform();                    ///< in [0, 1), 53 random bits; Python's random()
    double uniform(double a, double b);  ///< a + (b - a) * uniform()

    /// Normally distributed; pairs are drawn together and the second one kept, as Python's gauss().
    double gauss(double mean, double deviation);

    /// A whole number in [a, b], each equally likely; a if b < a. A replay gives its number rounded
    /// down.
    std::int64_t whole(std::int64_t a, std::int64_t b);

    /// Has a draw been asked for that was not there?
    bool exhausted() const { return exhausted_; }

    /// Everything that later draws depend on, as words; from_words gives an equal generator. Empty
    /// for a default-made one.
    std::vector<std::uint64_t> words() const;

    /// The generator that words() came from; a default-made one if they cannot have come from any.
    static Random from_words(const std::vector<std::uint64_t>& words);

    /// Equal generators draw equal numbers for ever.
    friend bool operator==(const Random&, const Random&);

private:
    enum class Mode : std::uint8_t { empty, seeded, replay };

    std::uint32_t next_word();
    void refill();
    bool replayed(double& draw);

    Mode mode_ = Mode::empty;
    bool exhausted_ = false;
    bool has_spare_ = false;            // gauss() has its second value ready
    std::uint32_t position_ = 0;        // next word of state_, or next of draws_
    double spare_ = 0;                  // in standard deviations
    std::vector<std::uint32_t> state_;  // 624 words of MT19937 when seeded
    std::vector<double> draws_;         // when replaying
};

}  // namespace trellis
