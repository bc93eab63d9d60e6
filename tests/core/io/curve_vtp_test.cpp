// Curves in VTK's XML polydata files, in every encoding.
#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using CurveVtp = test::CurveFiles;

const std::vector<Point> kBentSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}};

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto byte = k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U;
      bits = bits << 8 | byte;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text.push_back(k + j > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * j) & 63U]);
    }
  }
  return text;
}

enum class Form { kInline, kAppendedRaw, kAppendedBase64 };

/// Writes arrays as VTK does.
struct Encoder {
  Form form = Form::kInline;
  bool compressed = false;
  bool wide = false;
  bool big_endian = false;
  std::string appended;

  template <class T>
  void append(std::string& bytes, T value) const {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big_endian != (std::endian::native == std::endian::big)) {
      std::reverse(raw.begin(), raw.end());
    }
    bytes.append(raw.data(), raw.size());
  }

  void append_size(std::string& bytes, std::size_t size) const {
    if (wide) {
      append(bytes, static_cast<std::uint64_t>(size));
    } else {
      append(bytes, static_cast<std::uint32_t>(size));
    }
  }

  std::string block(const std::string& data) const {
    const auto text = [&](const std::string& bytes) {
      return form == Form::kAppendedRaw ? bytes : base64(bytes);
    };
    std::string head;
    if (!compressed) {
      append_size(head, data.size());
      return text(head + data);
    }
    constexpr std::size_t kBlock = 40;
    std::string packed;
    append_size(head, (data.size() + kBlock - 1) / kBlock);
    append_size(head, kBlock);
    append_size(head, data.size() % kBlock);
    for (std::size_t at = 0; at < data.size(); at += kBlock) {
      const std::string part = data.substr(at, kBlock);
      std::string out(compressBound(static_cast<uLong>(part.size())), '\0');
      auto length = static_cast<uLongf>(out.size());
      compress(reinterpret_cast<Bytef*>(out.data()), &length,
               reinterpret_cast<const Bytef*>(part.data()), static_cast<uLong>(part.size()));
      packed += out.substr(0, length);
      append_size(head, length);
    }
    return text(head) + text(packed);
  }

  template <class T>
  std::string array(const std::string& type, const std::string& name,
                    const std::vector<T>& values) {
    std::string data;
    for (const T value : values) append(data, value);
    const std::string open = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"";
    if (form == Form::kInline) return open + "binary\">\n  " + block(data) + "\n</DataArray>\n";
    const std::string offset = std::to_string(appended.size());
    appended += block(data);
    return open + "appended\" offset=\"" + offset + "\"/>\n";
  }

  std::string file(const std::string& points, const std::string& lines) const {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\"";
    text += big_endian ? " byte_order=\"BigEndian\"" : " byte_order=\"LittleEndian\"";
    if (wide) text += " header_type=\"UInt64\"";
    if (compressed) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<PolyData>\n<Piece NumberOfPoints=\"4\" NumberOfLines=\"1\">\n<Points>\n" + points +
            "</Points>\n<Lines>\n" + lines + "</Lines>\n</Piece>\n</PolyData>\n";
    if (form != Form::kInline) {
      text += "<AppendedData encoding=\"";
      text += form == Form::kAppendedRaw ? "raw" : "base64";
      text += "\">\n_" + appended + "\n</AppendedData>\n";
    }
    return text + "</VTKFile>\n";
  }

  template <class Real, class Index>
  std::string square(const std::string& real, const std::string& index) {
    std::vector<Real> x;
    for (const Point& p : kBentSquare) {
      for (int k = 0; k < 3; ++k) x.push_back(static_cast<Real>(p[k]));
    }
    const std::string points = array(real, "Points", x);
    const std::string lines = array(index, "connectivity", std::vector<Index>{0, 1, 2, 3, 0}) +
                              array(index, "offsets", std::vector<Index>{5});
    return file(points, lines);
  }
};

std::vector<Encoder> all_encoders() {
  std::vector<Encoder> result;
  for (const Form form : {Form::kInline, Form::kAppendedRaw, Form::kAppendedBase64}) {
    for (int bits = 0; bits < 8; ++bits) {
      result.push_back({form, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, {}});
    }
  }
  return result;
}

TEST_F(CurveVtp, EveryEncodingOfDoubles) {
  for (Encoder encoder : all_encoders()) {
    const auto curves = read("a.vtp", encoder.square<double, std::int64_t>("Float64", "Int64"));
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_EQ(test::positions(curves[0]), kBentSquare);
  }
}

TEST_F(CurveVtp, EveryEncodingOfFloats) {
  for (Encoder encoder : all_encoders()) {
    const auto curves = read("a.vtp", encoder.square<float, std::int32_t>("Float32", "Int32"));
    ASSERT_EQ(curves.size(), 1U);
    ASSERT_EQ(test::positions(curves[0]).size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(test::positions(curves[0])[k], kBentSquare[k].cast<float>().cast<double>());
    }
  }
}

std::string ascii(const std::string& points, const std::string& connectivity,
                  const std::string& offsets, const std::string& count = "4") {
  return "<VTKFile type=\"PolyData\">\n<PolyData>\n<Piece NumberOfPoints=\"" + count +
         "\" NumberOfLines=\"1\">\n<Points>\n<DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"ascii\">" +
         points +
         "</DataArray>\n</Points>\n<Lines>\n<DataArray type=\"Int32\" Name=\"connectivity\" "
         "format=\"ascii\">" +
         connectivity +
         "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray>\n</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

const std::string kFour = "0 0 0  1 0 0\n1 1 0.1  0 1 0";

TEST_F(CurveVtp, Ascii) {
  const auto curves = read("a.vtp", ascii(kFour, "0 1 2 3", "4"));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]), kBentSquare);
}

TEST_F(CurveVtp, SegmentsAreJoined) {
  const auto curves = read("a.vtp", ascii(kFour, "1 2 0 1 2 3", "2 4 6"));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(test::positions(curves[0]), kBentSquare);
}

TEST_F(CurveVtp, SeveralPieces) {
  std::string text = ascii(kFour, "0 1", "2");
  const std::size_t from = text.find("<Piece");
  const std::size_t to = text.find("</PolyData>");
  std::string piece = text.substr(from, to - from);
  piece.replace(piece.find("0 0 0  1 0 0"), 12, "5 0 0  6 0 0");
  const auto curves = read("a.vtp", text.insert(to, piece));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(test::positions(curves[0])[0], Point(0, 0, 0));
  EXPECT_EQ(test::positions(curves[1])[0], Point(5, 0, 0));
}

TEST_F(CurveVtp, SegmentsWithPointsOfTheirOwnAreJoinedByPosition) {
  const auto curves = read(
      "a.vtp", ascii("0 0 0  1 0 0\n1 0 0  1 1 0.1  1 1 0.1  0 1 0", "0 1 2 3 4 5", "2 4 6", "6"));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(test::positions(curves[0]), kBentSquare);
}

TEST_F(CurveVtp, RefusesMalformedXml) {
  expect_refused("a.vtp", "hello", {"line 1"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\">\n<PolyData>\n", {"line", "XML"});
  expect_refused("a.vtp", "<VTKFile type=\"ImageData\"/>", {"PolyData"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\"><PolyData/></VTKFile>", {"no lines"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\" compressor=\"vtkLZ4DataCompressor\"/>",
                 {"vtkLZ4DataCompressor"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\" header_type=\"UInt16\"/>", {"header_type"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\" byte_order=\"Middle\"/>", {"byte_order"});
  expect_refused("a.vtp", "<VTKFile type=\"PolyData\"><AppendedData encoding=\"raw\">", {"'_'"});
}

TEST_F(CurveVtp, RefusesMalformedArrays) {
  expect_refused("a.vtp", ascii(kFour, "0 4", "2"), {"line 0", "no point 4", "has 4"});
  expect_refused("a.vtp", ascii(kFour, "0 -1", "2"), {"line 0", "-1"});
  expect_refused("a.vtp", ascii(kFour, "0 1.5", "2"), {"1.5"});
  expect_refused("a.vtp", ascii(kFour, "0 1 2", "1 3"), {"line 0", "two points"});
  expect_refused("a.vtp", ascii(kFour, "0 1", "3"), {"line 0", "more than there are"});
  expect_refused("a.vtp", ascii(kFour, "0 1", "-2"), {"line 0"});
  expect_refused("a.vtp", ascii(kFour, "0 1 2 3", "4 2"), {"line 1"});
  expect_refused("a.vtp", ascii(kFour, "0 1", "2", "5"), {"line 5", "5 points", "12 numbers"});
  expect_refused("a.vtp", ascii("0 0 0 1 0 nan 0 0 0 0 0 0", "0 1", "2"), {"line 5", "point 1"});
  expect_refused("a.vtp", ascii("0 0 0 1 0 x 0 0 0 0 0 0", "0 1", "2"), {"line 5", "'x'"});
  std::string odd = ascii(kFour, "0 1", "2");
  odd.replace(odd.find("Float32"), 7, "Float16");
  expect_refused("a.vtp", odd, {"line 5", "type"});
  std::string unnamed = ascii(kFour, "0 1", "2");
  unnamed.replace(unnamed.find("offsets"), 7, "endings");
  expect_refused("a.vtp", unnamed, {"<Lines>", "offsets"});
}

TEST_F(CurveVtp, RefusesMalformedEncodings) {
  const auto with = [](const std::string& attributes, const std::string& data) {
    return "<VTKFile type=\"PolyData\"" + attributes +
           "><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float32\" "
           "format=\"binary\">" +
           data + "</DataArray></Points><Lines/></Piece></PolyData></VTKFile>";
  };
  expect_refused("a.vtp", with("", "%%%%%%%%%%%%"), {"base64"});
  expect_refused("a.vtp", with("", "AAA"), {"too early"});
  expect_refused("a.vtp", with("", ""), {"too early"});
  Encoder encoder;
  std::string size;
  encoder.append_size(size, 4000000000U);
  expect_refused("a.vtp", with("", base64(size + "abcd")), {"too early"});
  std::string three;
  encoder.append_size(three, 3);
  expect_refused("a.vtp", with("", base64(three + "abc")), {"whole number of values"});

  const std::string zlib = " compressor=\"vtkZLibDataCompressor\"";
  const auto compressed = [&](std::size_t blocks, std::size_t block, std::size_t last,
                              std::size_t packed, const std::string& data) {
    std::string head;
    for (const std::size_t word : {blocks, block, last, packed}) encoder.append_size(head, word);
    return with(zlib, base64(head) + base64(data));
  };
  expect_refused("a.vtp", compressed(4000000000U, 12, 0, 4, "abcd"), {"too early"});
  expect_refused("a.vtp", compressed(1, 4000000000U, 0, 4, "abcd"), {"unpacks"});
  expect_refused("a.vtp", compressed(1, 12, 0, 4000000000U, "abcd"), {"too early"});
  expect_refused("a.vtp", compressed(1, 12, 0, 4, "abcd"), {"zlib"});
}

TEST_F(CurveVtp, RefusesOffsetsBeyondTheAppendedData) {
  Encoder encoder;
  encoder.form = Form::kAppendedRaw;
  std::string text = encoder.square<double, std::int64_t>("Float64", "Int64");
  text.replace(text.find("offset=\"0\""), 10, "offset=\"99999\"");
  expect_refused("a.vtp", text, {"offset", "beyond"});
}

TEST_F(CurveVtp, SurvivesDamage) {
  for (Encoder encoder : all_encoders()) {
    if (encoder.big_endian) continue;
    const std::string text = encoder.square<double, std::int64_t>("Float64", "Int64");
    try_damaged("a.vtp", text, 100);
    if (encoder.wide) try_every_prefix("a.vtp", text);
  }
}

}  // namespace
}  // namespace talweg
