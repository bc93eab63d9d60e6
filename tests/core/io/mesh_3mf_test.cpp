// 3MF: a zip archive made here, with a model in XML.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/format_bytes.hpp"

namespace talweg::test::three_mf_meshes {
namespace {

using Faces = std::vector<Triangle>;
using Files = std::vector<std::pair<std::string, std::string>>;

std::uint32_t sum_of(std::string_view bytes) {  // CRC-32 of zip archives
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

/// Deflate data with one uncompressed block.
std::string deflated(const std::string& bytes) {
  std::string packed(1, '\1');
  put_number(packed, static_cast<std::uint16_t>(bytes.size()));
  put_number(packed, static_cast<std::uint16_t>(~bytes.size()));
  return packed + bytes;
}

enum class Zip { kStored, kDeflated, kWide };

std::string zip(const Files& files, Zip kind = Zip::kStored, std::uint16_t flags = 0) {
  std::string bytes, directory;
  for (const auto& file : files) {
    const std::string &name = file.first, &content = file.second;
    const auto at = static_cast<std::uint32_t>(bytes.size());
    const std::string packed = kind == Zip::kDeflated ? deflated(content) : content;
    const auto method = static_cast<std::uint16_t>(kind == Zip::kDeflated ? 8 : 0);
    const auto sizes = [&](std::string& to, bool wide) {
      put_number(to, sum_of(content));
      put_number(to, wide ? 0xFFFFFFFFU : static_cast<std::uint32_t>(packed.size()));
      put_number(to, wide ? 0xFFFFFFFFU : static_cast<std::uint32_t>(content.size()));
      put_number(to, static_cast<std::uint16_t>(name.size()));
    };
    const bool wide = kind == Zip::kWide;
    bytes += "PK\3\4";
    for (const std::uint16_t x :
         {std::uint16_t{20}, flags, method, std::uint16_t{0}, std::uint16_t{0}}) {
      put_number(bytes, x);
    }
    sizes(bytes, false);
    put_number(bytes, std::uint16_t{0});
    bytes += name + packed;
    directory += "PK\1\2";
    for (const std::uint16_t x : {std::uint16_t{20}, std::uint16_t{20}, flags, method,
                                  std::uint16_t{0}, std::uint16_t{0}}) {
      put_number(directory, x);
    }
    sizes(directory, wide);
    put_number(directory, static_cast<std::uint16_t>(wide ? 28 : 0));
    for (int k = 0; k < 3; ++k) put_number(directory, std::uint16_t{0});
    put_number(directory, std::uint32_t{0});
    put_number(directory, wide ? 0xFFFFFFFFU : at);
    directory += name;
    if (!wide) continue;
    put_number(directory, std::uint16_t{1});
    put_number(directory, std::uint16_t{24});
    for (const std::uint64_t x :
         {std::uint64_t{content.size()}, std::uint64_t{packed.size()}, std::uint64_t{at}}) {
      put_number(directory, x);
    }
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes += directory;
  bytes += "PK\5\6" + std::string(4, '\0');
  for (int k = 0; k < 2; ++k) put_number(bytes, static_cast<std::uint16_t>(files.size()));
  put_number(bytes, static_cast<std::uint32_t>(directory.size()));
  put_number(bytes, start);
  return bytes + std::string(2, '\0');
}

const std::string kRels =
    R"(<Relationships><Relationship Target="/3D/own name.model" Id="r"
    Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";

std::string mesh(const std::string& id, const std::string& more = "") {
  return "<object id=\"" + id + "\" " + more +
         R"(><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1.5" y="0" z="0"/>
         <vertex x="0" y="1e0" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/>
         </triangles></mesh></object>)";
}
std::string model(const std::string& objects, const std::string& items,
                  const std::string& unit = "") {
  return "<?xml version=\"1.0\"?>\n<model" + unit + "><resources>" + objects +
         "</resources><build>" + items + "</build></model>";
}
Files files(const std::string& text) {
  return {{"_rels/.rels", kRels}, {"3D/own name.model", text}};
}

TEST(ThreeMf, StoredPackedAndWideArchives) {
  const std::string text = model(mesh("1", "name=\"part\""), "<item objectid=\"1\"/>");
  for (const Zip kind : {Zip::kStored, Zip::kDeflated, Zip::kWide}) {
    MeshAttributes attributes;
    const MeshLists lists = read_mesh("a.3mf", zip(files(text), kind), attributes);
    EXPECT_EQ(lists.points, (std::vector<Point>{{0, 0, 0}, {1.5, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}}));
    EXPECT_TRUE(lists.notes.empty());
    ASSERT_EQ(attributes.names.size(), 1U);
    EXPECT_EQ(attributes.names[0].names[1], "part");
  }
  EXPECT_EQ(read_mesh("a.3mf", zip({{"3D/3dmodel.model", text}})).triangles.size(), 1U);
}

TEST(ThreeMf, ItemsComponentsAndOtherParts) {
  // The rows of the transform: x stays, y goes to z, z to -y; then a shift by (10, 20, 30).
  const std::string turn = R"( transform="1 0 0 0 0 1 0 -1 0 10 20 30")";
  const std::string text = model(
      mesh("1") + mesh("5", "type=\"support\"") +
          R"(<object id="2"><components><component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>
          <component objectid="7" p:path="/3D/other.model"/></components></object>)",
      "<item objectid=\"2\"" + turn + R"(/><item objectid="5"/>
      <item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)");
  Files all = files(text);
  all.emplace_back("3D/other.model", model(mesh("7"), ""));
  const MeshLists lists = read_mesh("a.3mf", zip(all));
  ASSERT_EQ(lists.points.size(), 9U);
  EXPECT_EQ(lists.points[1], Point(13, 20, 30));  // 1.5 doubled
  EXPECT_EQ(lists.points[2], Point(10, 20, 32));  // y doubled, now z
  EXPECT_EQ(lists.points[4], Point(11.5, 20, 30));
  EXPECT_EQ(lists.points[7], Point(-1.5, 0, 0));
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}, {3, 4, 5}, {6, 8, 7}}));  // the last is mirrored
  EXPECT_EQ(lists.notes, std::vector<std::string>{"1 supports of the build were left out."});
}

TEST(ThreeMf, UnitsAreRead) {
  const std::string item = "<item objectid=\"1\"/>";
  const auto unit_of = [&](const char* attribute) {
    return read_mesh("a.3mf", zip(files(model(mesh("1"), item, attribute)))).unit.value().code();
  };
  EXPECT_EQ(unit_of(""), "mm");
  EXPECT_EQ(unit_of(" unit=\"millimeter\""), "mm");
  EXPECT_EQ(unit_of(" unit=\"inch\""), "[in_i]");
  EXPECT_NE(
      refusal_of("a.3mf", zip(files(model(mesh("1"), item, " unit=\"mile\"")))).find("'mile'"),
      std::string::npos);
}

TEST(ThreeMf, Errors) {
  const auto says = [](const std::string& bytes, const char* words) {
    EXPECT_NE(refusal_of("a.3mf", bytes).find(words), std::string::npos)
        << refusal_of("a.3mf", bytes);
  };
  const std::string item = "<item objectid=\"1\"/>";
  const std::string good = zip(files(model(mesh("1"), item)));
  says("hello", "this is not a zip archive");
  says(good.substr(0, good.size() - 30), "no directory at its end");
  says(zip({{"other.txt", "x"}}), "the zip archive has no 3D/3dmodel.model");
  says(zip(files("<model>")), "3D/own name.model, line 1: it is not well-formed XML");
  says(zip(files(model(mesh("1"), "<item objectid=\"3\"/>"))), "there is no object '3'");
  says(zip(files(model(mesh("1"), ""))), "its build has no triangles");
  says(zip(files(model("<object id=\"1\"><components><component objectid=\"1\"/></components>"
                       "</object>",
                       item))),
       "nest deeper than 64 levels");
  says(zip(files(model(mesh("1"), "<item objectid=\"1\" transform=\"1 2\"/>"))), "twelve numbers");
  std::string text = model(mesh("1"), item);
  text.replace(text.find("v3=\"2\""), 6, "v3=\"3\"");
  says(zip(files(text)), "line 3, <triangle>: v3 is 3, but the object has 3 vertices");
  text = model(mesh("1"), item);
  text.replace(text.find("1.5"), 3, "1,5");
  says(zip(files(text)), "<vertex>: expected a number for x, found '1,5'");
  std::string damaged = good;
  damaged[damaged.find("1.5")] = '2';
  says(damaged, "in the zip archive is damaged");
  says(zip(files(model(mesh("1"), item)), Zip::kStored, 1), "encrypted");
}

}  // namespace
}  // namespace talweg::test::three_mf_meshes
