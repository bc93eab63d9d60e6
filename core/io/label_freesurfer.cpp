// FreeSurfer's annotations (binary, big-endian) and labels (text).
#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

class AnnotReader {
 public:
  explicit AnnotReader(const Source& source) : source_(source), cursor_(source.bytes) {}

  LabelFile read() {
    read_vertices();
    if (cursor_.left() == 0 || number("the tag of the color table") == 0) return std::move(file_);
    const std::int32_t entries = number("the size or version of the color table");
    if (entries >= 0) {
      string("the color table's file");
      for (std::int32_t k = 0; k < entries; ++k) read_entry(k);
    } else if (entries == -2) {
      number("the number of labels");
      string("the color table's file");
      const std::int32_t count = number("the number of entries");
      for (std::int32_t k = 0; k < count; ++k) read_entry(number("the number of an entry"));
    } else {
      fail(fmt::format("expected a color table of version 2, found {}", -std::int64_t{entries}));
    }
    name_colors();
    return std::move(file_);
  }

 private:
  static constexpr std::int64_t kUnnamed = -1;

  void read_vertices() {
    const std::int32_t count = number("the number of vertices");
    if (count < 0 || static_cast<std::size_t>(count) > cursor_.left() / 8) {
      fail(
          fmt::format("it announces {} vertices, but holds {} at most", count, cursor_.left() / 8));
    }
    file_.labels.assign(static_cast<std::size_t>(count), 0);
    std::vector<bool> seen(file_.labels.size(), false);
    for (std::int32_t k = 0; k < count; ++k) {
      const std::int32_t vertex = number("a vertex");
      if (vertex < 0 || vertex >= count) {
        fail(fmt::format("entry {} is for vertex {}, but there are {}", k, vertex, count));
      }
      const auto v = static_cast<std::size_t>(vertex);
      if (seen[v]) fail(fmt::format("vertex {} comes twice", vertex));
      seen[v] = true;
      file_.labels[v] = number("a color");
    }
  }

  void read_entry(std::int32_t index) {
    if (index < 0) fail(fmt::format("an entry of the color table has the number {}", index));
    std::string name = string("a name");
    std::int64_t color = 0;  // red + 256 green + 65536 blue; the fourth number is transparency
    LabelColor parts{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t part = number("a color");
      if (k < 3) color += part << (8 * k);
      parts[k] = std::clamp(static_cast<double>(k < 3 ? part : 255 - part) / 255, 0.0, 1.0);
    }
    file_.colors.emplace(index, parts);
    if (!file_.names.emplace(index, std::move(name)).second) {
      fail(fmt::format("entry {} of the color table comes twice", index));
    }
    entry_of_.emplace(color, index);  // the first of equal colors wins
  }

  /// Replaces colors by the numbers of their entries in the color table.
  void name_colors() {
    for (std::size_t v = 0; v < file_.labels.size(); ++v) {
      std::int64_t& label = file_.labels[v];
      if (label == 0) {
        label = kUnnamed;
        continue;
      }
      const auto found = entry_of_.find(label);
      if (found == entry_of_.end()) {
        fail(fmt::format("vertex {} has the color {}, which the color table does not have", v,
                         label));
      }
      label = found->second;
    }
  }

  std::int32_t number(const char* what) {
    const char* at = cursor_.take(4);
    if (at == nullptr) fail(fmt::format("it ends where {} should be", what));
    return load<std::int32_t>(at, std::endian::native == std::endian::little);
  }

  std::string string(const char* what) {
    const std::int32_t length = number(what);
    const char* at = length < 0 ? nullptr : cursor_.take(static_cast<std::size_t>(length));
    if (at == nullptr)
      fail(
          fmt::format("{} has {} characters, but {} bytes are left", what, length, cursor_.left()));
    const std::string_view all(at, static_cast<std::size_t>(length));
    return printable(all.substr(0, all.find('\0')), kLongestName);
  }

  [[noreturn]] void fail(const std::string& what) const { cannot_read(source_.path, what); }

  const Source& source_;
  ByteCursor cursor_;
  LabelFile file_;
  std::map<std::int64_t, std::int64_t> entry_of_;  // by color
};

}  // namespace

LabelFile read_annot_labels(const Source& source) { return AnnotReader(source).read(); }

LabelFile read_freesurfer_label(const Source& source, std::size_t vertex_count) {
  WordScanner text(source.path, source.bytes);
  if (text.rest_of_line().substr(0, 1) != "#") {
    text.fail("expected a first line that begins with #");
  }
  text.next_line();
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32U;
  const std::uint64_t count = text.count(text.word(), "the number of vertices", kMost);
  LabelFile file;
  file.labels.assign(vertex_count, 0);
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto v =
        static_cast<std::size_t>(text.count(text.word(), "a vertex of the mesh", vertex_count));
    for (int c = 0; c < 3; ++c) text.number(text.word(), "a coordinate");
    text.number(text.word(), "a value");
    file.labels[v] = 1;
  }
  if (const std::string_view more = text.word(); !more.empty()) {
    text.fail("the end of the file", more);
  }
  return file;
}

}  // namespace talweg::formats
