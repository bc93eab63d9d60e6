// Labels with a table of names and colors: FreeSurfer's .annot and GIFTI's .label.gii.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_bytes.hpp"

namespace talweg::formats {
namespace {

constexpr std::int64_t kNone = -1;  // .annot: a vertex without color
constexpr std::int64_t kMostColors = 0xFFFFFF;

/// A color unlike the colors of labels with near numbers: hues by the golden ratio.
LabelColor own_color(std::int64_t label) {
  constexpr double kGolden = 0.6180339887498949;
  const double turns = kGolden * static_cast<double>(label);
  const double hue = 6 * (turns - std::floor(turns));
  const auto part = [&](double shift) {
    const double at = std::fmod(hue + shift, 6.0);
    const double level = std::clamp(std::min(at, 4 - at), 0.0, 1.0);
    return std::round(255 * (0.25 + 0.7 * level)) / 255;
  };
  return {part(2), part(0), part(4), 1};
}

std::int64_t byte_of(double part) { return static_cast<std::int64_t>(std::lround(255 * part)); }

std::int64_t color_number(const LabelColor& color) {
  return byte_of(color[0]) + (byte_of(color[1]) << 8U) + (byte_of(color[2]) << 16U);
}

void put_number(std::string& bytes, std::int64_t value) {
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes.push_back(static_cast<char>(value >> (shift - 8) & 0xFF));
  }
}

void put_string(std::string& bytes, const std::string& text) {
  put_number(bytes, static_cast<std::int64_t>(text.size()) + 1);
  bytes.append(text).push_back('\0');
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result.push_back(c);
    }
  }
  return result;
}

}  // namespace

std::map<std::int64_t, NamedLabel> table_of(const LabelFile& labels) {
  std::map<std::int64_t, NamedLabel> table;
  for (const auto& [label, name] : labels.names) table[label].name = name;
  for (const std::int64_t label : labels.labels) table.try_emplace(label);
  for (auto& [label, entry] : table) {
    if (entry.name.empty()) entry.name = label == kNone ? "???" : fmt::format("label_{}", label);
    const auto color = labels.colors.find(label);
    const bool given = color != labels.colors.end();
    entry.color = given ? color->second : label == kNone ? LabelColor{} : own_color(label);
  }
  return table;
}

std::string annot_labels(const LabelContent& content) {
  std::map<std::int64_t, NamedLabel> table = table_of(content.labels);
  table.erase(kNone);
  std::set<std::int64_t> taken = {0};  // the color of vertices without label
  std::map<std::int64_t, std::int64_t> color_of = {{kNone, 0}};
  for (const auto& [label, entry] : table) {
    if (label < 0 || label > kMostColors) {
      cannot_write(content.path, fmt::format("an .annot holds labels from -1 (none) to {}, and one "
                                             "is {} (.label.gii holds it)",
                                             kMostColors, label));
    }
    std::int64_t color = color_number(entry.color);
    while (taken.contains(color)) color = (color + 1) & kMostColors;
    taken.insert(color);
    color_of[label] = color;
  }
  std::string bytes;
  put_number(bytes, static_cast<std::int64_t>(content.labels.labels.size()));
  std::int64_t vertex = 0;
  for (const std::int64_t label : content.labels.labels) {
    put_number(bytes, vertex++);
    put_number(bytes, color_of.at(label));
  }
  for (const std::int64_t number : {1, -2}) put_number(bytes, number);
  put_number(bytes, table.empty() ? 0 : table.rbegin()->first + 1);
  put_string(bytes, "talweg");
  put_number(bytes, static_cast<std::int64_t>(table.size()));
  for (const auto& [label, entry] : table) {
    put_number(bytes, label);
    put_string(bytes, entry.name);
    for (unsigned shift = 0; shift < 24; shift += 8) {
      put_number(bytes, color_of[label] >> shift & 0xFF);
    }
    put_number(bytes, 255 - byte_of(entry.color[3]));
  }
  return bytes;
}

std::string gifti_labels(const LabelContent& content) {
  const std::map<std::int64_t, NamedLabel> table = table_of(content.labels);
  using Limits = std::numeric_limits<std::int32_t>;
  for (const auto& [label, entry] : table) {
    if (label >= Limits::min() && label <= Limits::max()) continue;
    cannot_write(content.path,
                 fmt::format("a .label.gii holds labels of 32 bits, and one is {}", label));
  }
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
      "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"1\">\n<MetaData/>\n<LabelTable>\n";
  const auto out = std::back_inserter(text);
  for (const auto& [label, entry] : table) {
    const auto& [red, green, blue, alpha] = entry.color;
    fmt::format_to(out,
                   "<Label Key=\"{}\" Red=\"{:.9g}\" Green=\"{:.9g}\" Blue=\"{:.9g}\" "
                   "Alpha=\"{:.9g}\">{}</Label>\n",
                   label, red, green, blue, alpha, escaped(entry.name));
  }
  fmt::format_to(out,
                 "</LabelTable>\n<DataArray Intent=\"NIFTI_INTENT_LABEL\" "
                 "DataType=\"NIFTI_TYPE_INT32\" ArrayIndexingOrder=\"RowMajorOrder\" "
                 "Dimensionality=\"1\" Dim0=\"{}\" Encoding=\"ASCII\" Endian=\"LittleEndian\" "
                 "ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData/>\n<Data>",
                 content.labels.labels.size());
  text += text_labels(content);
  return text + "</Data>\n</DataArray>\n</GIFTI>\n";
}

}  // namespace talweg::formats
