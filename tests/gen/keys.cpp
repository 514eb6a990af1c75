// Keys as text, their validity and their hash.
#include <gtest/gtest.h>

#include <cstring>
#include <unordered_set>

#include "tests/gen/states.h"

namespace anteroom::gen {
namespace {

constexpr int kRounds = 3000;

template <class Key>
Key randomBytes(RandomStates& random) {
  Key key;
  auto* bytes = reinterpret_cast<uint8_t*>(&key);
  for (size_t i = 0; i < sizeof key; ++i) bytes[i] = random.byte();
  return key;
}

template <class Key>
Key withoutRandomBit(Key key, RandomStates& random) {
  auto* bytes = reinterpret_cast<uint8_t*>(&key);
  const int bit = random.index(static_cast<int>(sizeof key) * 8);
  bytes[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
  return key;
}

template <class Key>
void expectRoundTrip(const Key& key) {
  Key parsed{};
  ASSERT_TRUE(parse(describe(key), parsed)) << describe(key);
  EXPECT_TRUE(parsed == key) << describe(key) << '\n' << describe(parsed);
}

TEST(Keys, RoundTripThroughText) {
  RandomStates random(10);
  for (int i = 0; i < kRounds; ++i) {
    const Keys keys = keysOf(random.next(), {!random.coin(4), !random.coin(4)});
    expectRoundTrip(keys.fragment);
    expectRoundTrip(keys.vertex);
  }
}

TEST(Keys, ParseLeavesTheKeyAloneOnBadText) {
  const Keys keys = keysOf(litState(2));
  VertexKey key = keys.vertex;
  const std::string good = describe(keys.vertex);
  for (const std::string& bad :
       {std::string(), std::string("vertex"), std::string("fragment"), good + " ", good + " lights=9",
        good + " lights=-1", good + " lights=", good + " nonsense=1", good + " fog=2", good + "  fog",
        " " + good, good + " position=unread", good + " shade=lit=lit", good + " two-sided=1"}) {
    EXPECT_FALSE(parse(bad, key)) << bad;
    EXPECT_TRUE(key == keys.vertex);
  }
  FragmentKey fragment = keysOf(texturedState()).fragment;
  const FragmentKey before = fragment;
  const std::string unit = "fragment unit0=2d read0=st rgb0=";
  ASSERT_TRUE(parse(unit + "modulate(previous,texture0)", fragment));
  for (const char* bad :
       {"modulate(previous)", "modulate(previous,texture0,texture0)", "modulate(previous,texture9)",
        "modulate previous,texture0)", "modulate(previous,texture0", "modulate(,)", "modulate()",
        "(previous,texture0)", "modulate(previous,texture0)*3", "modulate(texture0,previous)",
        "modulate(previous,texture1)", "replace(previous)", "keep()", "dot3(1-1-previous,texture0)"}) {
    fragment = before;
    EXPECT_FALSE(parse(unit + bad, fragment)) << bad;
    EXPECT_TRUE(fragment == before);
  }
}

TEST(Keys, ParseSurvivesDamagedText) {
  RandomStates random(11);
  for (int i = 0; i < kRounds; ++i) {
    const Keys keys = keysOf(random.next());
    std::string text = random.coin() ? describe(keys.fragment) : describe(keys.vertex);
    for (int n = random.index(4); n >= 0; --n)
      text[random.index(static_cast<int>(text.size()))] ^= 1 << random.index(8);
    text.resize(random.coin() ? text.size() : random.index(static_cast<int>(text.size())));
    FragmentKey fragment{};
    VertexKey vertex{};
    if (parse(text, fragment)) {
      EXPECT_TRUE(valid(fragment)) << text;
    }
    if (parse(text, vertex)) {
      EXPECT_TRUE(valid(vertex)) << text;
    }
  }
}

TEST(Keys, RandomBytesAreInvalid) {
  RandomStates random(12);
  for (int i = 0; i < kRounds; ++i) {
    EXPECT_FALSE(valid(randomBytes<FragmentKey>(random)));
    EXPECT_FALSE(valid(randomBytes<VertexKey>(random)));
  }
  VertexKey zero{};
  EXPECT_FALSE(valid(zero));  // a position is always read
}

// A flipped bit gives another key that is canonical, or one that is refused; what is accepted can be emitted.
TEST(Keys, FlippedBits) {
  RandomStates random(13);
  int refused = 0, accepted = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Keys keys = keysOf(random.next());
    const FragmentKey fragment = withoutRandomBit(keys.fragment, random);
    const VertexKey vertex = withoutRandomBit(keys.vertex, random);
    refused += !valid(fragment) + !valid(vertex);
    accepted += valid(fragment) + valid(vertex);
    if (valid(fragment)) expectRoundTrip(fragment);
    if (valid(vertex)) expectRoundTrip(vertex);
    if (i % 10) continue;
    if (valid(fragment)) {
      EXPECT_FALSE(compile(Stage::Fragment, emitFragment(fragment)).spirv.empty()) << emitFragment(fragment);
    }
    if (valid(vertex)) {
      EXPECT_FALSE(compile(Stage::Vertex, emitVertex(vertex)).spirv.empty()) << emitVertex(vertex);
    }
  }
  EXPECT_GT(refused, accepted);
  EXPECT_GT(accepted, 0);
}

TEST(Keys, DeadBitsAreRefused) {
  FragmentKey fragment = keysOf(texturedState()).fragment;
  ASSERT_TRUE(valid(fragment));
  const auto refused = [](auto key, auto change) {
    change(key);
    return !valid(key);
  };
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.pointYUp = 1; }));
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.units[4].target = TextureTarget::Texture2D; }));
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.units[0].target = TextureTarget::None; }));
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.units[0].coordinate = Coordinate::Strq; }));
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.units[0].rgb.arguments[2].source = Source::One; }));
  EXPECT_TRUE(refused(fragment, [](FragmentKey& k) { k.alphaTest = AlphaTest::Never; }));
  VertexKey vertex = keysOf(texturedState()).vertex;
  ASSERT_TRUE(valid(vertex));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.lights = 1; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.normalize = 1; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kNormal] = Fetch::Float; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kPosition] = Fetch::NormedByte; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.clipVaryings = 1; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.palette = 2; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kMatrixIndex] = Fetch::Uint; }));
  vertex = keysOf(skinnedState(true)).vertex;
  ASSERT_TRUE(valid(vertex));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.palette = 0; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.palette = 5; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kWeight] = Fetch::Unread; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kMatrixIndex] = Fetch::Float; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fetch[kWeight] = Fetch::Int; }));
  EXPECT_TRUE(refused(vertex, [](VertexKey& k) { k.fogW = 1; }));
}

TEST(Keys, HashesDiffer) {
  RandomStates random(14);
  std::unordered_set<uint64_t> hashes;
  std::unordered_set<std::string> texts;
  for (int i = 0; i < kRounds; ++i) {
    const Keys keys = keysOf(random.next());
    hashes.insert(hash(keys.fragment));
    hashes.insert(hash(keys.vertex));
    texts.insert(describe(keys.fragment));
    texts.insert(describe(keys.vertex));
  }
  EXPECT_EQ(hashes.size(), texts.size());
}

}  // namespace
}  // namespace anteroom::gen
