// Python's random numbers, bit for bit, checked by sums over what CPython 3.11 draws; replays;
// saving and loading.
// SPDX-License-Identifier: MIT
#include "core/random.h"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace trellis {
namespace {

// FNV-1a over 64-bit words
class Sum {
public:
    void add(std::uint64_t word) { sum_ = (sum_ ^ word) * 0x100000001B3u; }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
    std::uint64_t value() const { return sum_; }

private:
    std::uint64_t sum_ = 0xCBF29CE484222325u;
};

struct Golden {
    std::int64_t seed;
    std::array<std::uint64_t, 5> sums;  // random, uniform, gauss, randint, large randints
};

// one generator per seed, drawn from in this order; made by python3:
//   r = random.Random(seed)
//   1000 × r.random(), 1000 × r.uniform(-math.pi, math.pi), 1001 × r.gauss(1.5, 0.25), 1000 ×
//   r.randint(-5, 1000000), 10 × r.randint(-2**63, 2**63 - 1) + 100 × r.randint(0, 2**40) + 3 ×
//   r.randint(3, 3)
// clang-format off
constexpr Golden goldens[] = {
    {0, {0xcf5cc08cefe28534u, 0x6f7cf695e33f59c2u, 0xba3cb3707ee63cfeu, 0x1fc6265944ab8398u, 0x5841601931895646u}},
    {1, {0x7796649bfb81f76bu, 0x30c1911959c330d5u, 0xdcf56d9344d6a508u, 0x8a843728d7fa339bu, 0xfa4a76fdda61a3e3u}},
    {2, {0x8187e4a6e6a622efu, 0x72b337832600589fu, 0x94465117ece7b88du, 0xa9cc02a2819aa3aeu, 0xcb3d5224e495bc26u}},
    {7, {0xe2d5df7ddecb1ec4u, 0x944c44e9400ca9a3u, 0x8cac3e7a0301f967u, 0xffa6e7fe16983954u, 0xa3d56f0be8e770f0u}},
    {42, {0xad3fa9bfc95dcc51u, 0xd86876329d64f2cau, 0xca7c2d91540b5863u, 0x70336011752878dcu, 0x7881f9433fd4274eu}},
    {624, {0xdc43bd66c4fe9a1bu, 0x527ed0fddca2bb31u, 0xb123559d96a73058u, 0x0fbb4ec451c53177u, 0x5337fc5a2a6ef1c6u}},
    {-1, {0x7796649bfb81f76bu, 0x30c1911959c330d5u, 0xdcf56d9344d6a508u, 0x8a843728d7fa339bu, 0xfa4a76fdda61a3e3u}},
    {-42, {0xad3fa9bfc95dcc51u, 0xd86876329d64f2cau, 0xca7c2d91540b5863u, 0x70336011752878dcu, 0x7881f9433fd4274eu}},
    {2147483648, {0x100330682f201c0eu, 0xbe6ba77190d47daau, 0xa23afac936ba7fe1u, 0x3db8aea5a051da7du, 0x6a23ba322c0abb82u}},
    {4294967295, {0x4f529d0083a09411u, 0x102deab6148ba6eau, 0xcf972926b04c48ebu, 0x628c46ecdc884aa5u, 0x7448189884d9b492u}},
    {4294967296, {0x879844ac16b06c45u, 0x1990d7505a3b44f8u, 0xd95613cb63438772u, 0x1bae46d056f945fau, 0x63d955b72f51e430u}},
    {4294967297, {0xe59e3dd4901ac187u, 0x711c4d18e0fac975u, 0x9fa05b11148ccd6au, 0x0609e1ed889c058du, 0x69cf0ab1652aaa79u}},
    {9007199254740992, {0x8b8443dfc23ae913u, 0xd2aa31030dc10b17u, 0xc66ee95e96be07ceu, 0x9ca380ee76b1c57bu, 0xbbdbd040adee4027u}},
    {9223372036854775807, {0x4472f4fc4a2796a2u, 0xd3d00aa331aa7055u, 0x8c6713f1d7437dc5u, 0x96310780687793a4u, 0x4fee8ac8b1b7c713u}},
    {std::numeric_limits<std::int64_t>::min(), {0xc074624b274a8b4fu, 0x0e5decd85aced42bu, 0xcef5ee0406ca17ddu, 0xc8d4f2c6ba50da38u, 0xe0b7dd969ba8bcfau}},
};
// clang-format on

template <class Draw>
std::uint64_t sum_of(int count, Draw draw) {
    Sum sum;
    for (int i = 0; i < count; ++i)
        sum.add(draw());
    return sum.value();
}

}  // namespace

TEST_CASE("random: draws what CPython draws") {
    CHECK(Random(std::int64_t{42}).uniform() == 0.6394267984578837);
    for (const Golden& golden : goldens) {
        CAPTURE(golden.seed);
        Random r(golden.seed);
        CHECK(sum_of(1000, [&] { return r.uniform(); }) == golden.sums[0]);
        CHECK(sum_of(1000, [&] { return r.uniform(-3.141592653589793, 3.141592653589793); }) ==
              golden.sums[1]);
        CHECK(sum_of(1001, [&] { return r.gauss(1.5, 0.25); }) == golden.sums[2]);
        CHECK(sum_of(1000, [&] { return r.whole(-5, 1'000'000); }) == golden.sums[3]);
        Sum large;
        constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
        for (int i = 0; i < 10; ++i)
            large.add(r.whole(least, std::numeric_limits<std::int64_t>::max()));
        for (int i = 0; i < 100; ++i)
            large.add(r.whole(0, std::int64_t{1} << 40));
        for (int i = 0; i < 3; ++i)
            large.add(r.whole(3, 3));
        CHECK(large.value() == golden.sums[4]);
        CHECK_FALSE(r.exhausted());
    }
}

TEST_CASE("random: a copy draws the same, and is equal as long as both have drawn as often") {
    Random a(std::int64_t{7});
    static_cast<void>(a.gauss(0, 1));
    Random b = a;
    CHECK(a == b);
    CHECK(a.gauss(0, 1) == b.gauss(0, 1));
    CHECK(a == b);
    static_cast<void>(a.uniform());
    CHECK_FALSE(a == b);
    CHECK_FALSE(Random(std::int64_t{7}) == Random(std::int64_t{8}));
}

TEST_CASE("random: replays a list, then says that it is exhausted") {
    Random r = Random::replaying({1.5, -2.5, 3.25});
    CHECK(r.uniform(-100, 100) == 1.5);
    CHECK(r.whole(0, 10) == -3);
    CHECK(r.gauss(5, 5) == 3.25);
    CHECK_FALSE(r.exhausted());
    CHECK(r.uniform() == 0);
    CHECK(r.exhausted());
}

TEST_CASE("random: an empty generator draws 0 and is exhausted") {
    Random r;
    CHECK(r.words().empty());
    CHECK(r.uniform(1, 2) == 0);
    CHECK(r.exhausted());
}

TEST_CASE("random: words hold everything that later draws depend on") {
    Random seeded(std::int64_t{3});
    for (int i = 0; i < 700; ++i)
        static_cast<void>(seeded.uniform());
    static_cast<void>(seeded.gauss(0, 1));
    Random replay = Random::replaying({1, 2});
    static_cast<void>(replay.uniform());
    Random spent = replay;
    static_cast<void>(spent.uniform());
    static_cast<void>(spent.uniform());
    Random empty_spent;
    static_cast<void>(empty_spent.uniform());
    for (const Random& r :
         {Random(), Random(std::int64_t{1}), seeded, replay, spent, empty_spent}) {
        Random loaded = Random::from_words(r.words());
        CHECK(loaded == r);
        Random original = r;
        CHECK(loaded.gauss(0, 1) == original.gauss(0, 1));
        CHECK(loaded.uniform() == original.uniform());
    }
}

TEST_CASE("random: words that cannot be a generator's give an empty one") {
    std::vector<std::uint64_t> words = Random(std::int64_t{1}).words();
    words.pop_back();
    CHECK(Random::from_words(words) == Random());
    words = Random(std::int64_t{1}).words();
    words[1] = 625;
    CHECK(Random::from_words(words) == Random());
    CHECK(Random::from_words({3, 0, 0}) == Random());
    CHECK(Random::from_words({0, 1, 0}) == Random());
    CHECK(Random::from_words({2, 1, 0}) == Random());
    CHECK(Random::from_words({1}) == Random());
}

}  // namespace trellis
