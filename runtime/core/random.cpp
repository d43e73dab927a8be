// MT19937 (Matsumoto and Nishimura 1998) with CPython's seeding (Modules/_randommodule.c:
// random_seed) and CPython's distributions (Lib/random.py: uniform, gauss, randint). Covered by
// tests/core/random_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/random.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace trellis {
namespace {

constexpr std::size_t state_size = 624;
constexpr std::size_t shift_size = 397;

std::vector<std::uint32_t> seeded_by_word(std::uint32_t seed) {
    std::vector<std::uint32_t> state(state_size);
    state[0] = seed;
    for (std::uint32_t i = 1; i < state_size; ++i) {
        const std::uint32_t before = state[i - 1];
        state[i] = 1812433253u * (before ^ before >> 30) + i;
    }
    return state;
}

// the reference implementation's init_by_array
std::vector<std::uint32_t> seeded_by_key(const std::uint32_t* key, std::size_t key_size) {
    std::vector<std::uint32_t> state = seeded_by_word(19650218u);
    std::size_t i = 1;
    std::size_t j = 0;
    const auto advance = [&] {
        if (++i >= state_size) {
            state[0] = state[state_size - 1];
            i = 1;
        }
    };
    for (std::size_t k = state_size; k > 0; --k) {
        const std::uint32_t before = state[i - 1];
        state[i] = (state[i] ^ (before ^ before >> 30) * 1664525u) + key[j] +
                   static_cast<std::uint32_t>(j);
        advance();
        if (++j >= key_size) j = 0;
    }
    for (std::size_t k = state_size - 1; k > 0; --k) {
        const std::uint32_t before = state[i - 1];
        state[i] =
            (state[i] ^ (before ^ before >> 30) * 1566083941u) - static_cast<std::uint32_t>(i);
        advance();
    }
    state[0] = 0x80000000u;
    return state;
}

}  // namespace

Random::Random(std::int64_t seed) : mode_(Mode::seeded), position_(state_size) {
    // CPython takes the absolute value and splits it into 32-bit words, the least significant first
    const auto bits = static_cast<std::uint64_t>(seed);
    const std::uint64_t magnitude = seed < 0 ? 0 - bits : bits;
    const std::array key{static_cast<std::uint32_t>(magnitude),
                         static_cast<std::uint32_t>(magnitude >> 32)};
    state_ = seeded_by_key(key.data(), key[1] != 0 ? 2 : 1);
}

Random Random::replaying(std::vector<double> draws) {
    Random random;
    random.mode_ = Mode::replay;
    random.draws_ = std::move(draws);
    return random;
}

double Random::uniform() {
    double draw = 0;
    if (replayed(draw)) return draw;
    const std::uint32_t high = next_word() >> 5;
    const std::uint32_t low = next_word() >> 6;
    return (high * 67108864.0 + low) * (1.0 / 9007199254740992.0);
}

double Random::uniform(double a, double b) {
    double draw = 0;
    if (replayed(draw)) return draw;
    return a + (b - a) * uniform();
}

double Random::gauss(double mean, double deviation) {
    double draw = 0;
    if (replayed(draw)) return draw;
    double z = spare_;
    if (!std::exchange(has_spare_, !has_spare_)) {
        const double angle = uniform() * (2.0 * std::numbers::pi);
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        z = std::cos(angle) * radius;
        spare_ = std::sin(angle) * radius;
    } else {
        spare_ = 0;
    }
    return mean + z * deviation;
}

std::int64_t Random::whole(std::int64_t a, std::int64_t b) {
    double draw = 0;
    if (replayed(draw)) {
        const bool fits = draw >= -9223372036854775808.0 && draw < 9223372036854775808.0;
        return fits ? static_cast<std::int64_t>(std::floor(draw)) : 0;
    }
    if (b < a) return a;
    // as _randbelow_with_getrandbits: as many bits as the count has, drawn again until they are
    // below it. The count wraps to 0 for the whole range of std::int64_t, where Python's would be
    // 2^64: 65 bits, 3 words.
    const std::uint64_t count = static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a) + 1;
    const int bits = count == 0 ? 65 : 64 - std::countl_zero(count);
    for (;;) {
        // as getrandbits: the least significant word first, the last one cut to what is missing
        std::uint64_t drawn = 0;
        std::uint64_t overflow = 0;
        for (int done = 0; done < bits; done += 32) {
            std::uint64_t word = next_word();
            if (bits - done < 32) word >>= 32 - (bits - done);
            if (done < 64)
                drawn |= word << done;
            else
                overflow = word;
        }
        if (count == 0 ? overflow == 0 : drawn < count) {
            return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + drawn);
        }
    }
}

std::vector<std::uint64_t> Random::words() const {
    if (mode_ == Mode::empty && !exhausted_) return {};
    std::vector<std::uint64_t> words{static_cast<std::uint64_t>(mode_) |
                                         std::uint64_t{exhausted_} << 8 |
                                         std::uint64_t{has_spare_} << 9,
                                     position_, std::bit_cast<std::uint64_t>(spare_)};
    for (std::uint32_t word : state_)
        words.push_back(word);
    for (double draw : draws_)
        words.push_back(std::bit_cast<std::uint64_t>(draw));
    return words;
}

Random Random::from_words(const std::vector<std::uint64_t>& words) {
    if (words.size() < 3 || words[0] >> 10 != 0 || (words[0] & 0xFF) > 2) return {};
    Random random;
    random.mode_ = static_cast<Mode>(words[0] & 0xFF);
    random.exhausted_ = (words[0] >> 8 & 1) != 0;
    random.has_spare_ = (words[0] >> 9 & 1) != 0;
    random.spare_ = std::bit_cast<double>(words[2]);
    const std::size_t count = words.size() - 3;
    const std::size_t expected = random.mode_ == Mode::seeded  ? state_size
                                 : random.mode_ == Mode::empty ? 0
                                                               : count;
    const std::size_t last_position = random.mode_ == Mode::empty ? 0 : count;
    if (count != expected || words[1] > last_position) return {};
    random.position_ = static_cast<std::uint32_t>(words[1]);
    for (std::size_t i = 3; i < words.size(); ++i) {
        if (random.mode_ == Mode::seeded)
            random.state_.push_back(static_cast<std::uint32_t>(words[i]));
        else
            random.draws_.push_back(std::bit_cast<double>(words[i]));
    }
    return random;
}

bool operator==(const Random& a, const Random& b) {
    if (a.mode_ != b.mode_ || a.exhausted_ != b.exhausted_ || a.has_spare_ != b.has_spare_ ||
        a.position_ != b.position_ || a.state_ != b.state_ || a.draws_.size() != b.draws_.size()) {
        return false;
    }
    // bit for bit, so that a copy that replays NaN equals its original
    const auto same = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    };
    for (std::size_t i = 0; i < a.draws_.size(); ++i) {
        if (!same(a.draws_[i], b.draws_[i])) return false;
    }
    return same(a.spare_, b.spare_);
}

std::uint32_t Random::next_word() {
    if (position_ >= state_size) refill();
    std::uint32_t y = state_[position_++];
    y ^= y >> 11;
    y ^= y << 7 & 0x9D2C5680u;
    y ^= y << 15 & 0xEFC60000u;
    return y ^ y >> 18;
}

void Random::refill() {
    const auto twist = [](std::uint32_t upper, std::uint32_t lower, std::uint32_t far) {
        const std::uint32_t y = (upper & 0x80000000u) | (lower & 0x7FFFFFFFu);
        return far ^ y >> 1 ^ ((y & 1) != 0 ? 0x9908B0DFu : 0u);
    };
    for (std::size_t i = 0; i < state_size; ++i) {
        state_[i] =
            twist(state_[i], state_[(i + 1) % state_size], state_[(i + shift_size) % state_size]);
    }
    position_ = 0;
}

bool Random::replayed(double& draw) {
    if (mode_ == Mode::seeded) return false;
    if (position_ < draws_.size())
        draw = draws_[position_++];
    else
        exhausted_ = true;
    return true;
}

}  // namespace trellis
