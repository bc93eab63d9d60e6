#include "talweg/core/io/numpy_array.hpp"

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/number_text.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

/// The type of numbers of two or three characters, such as "i4", "u1", "f8" or "b1".
std::optional<NumberType> numpy_type(std::string_view name) {
  static constexpr std::pair<std::string_view, NumberType> kTypes[] = {
      {"b1", NumberType::kUint8},   {"i1", NumberType::kInt8},   {"u1", NumberType::kUint8},
      {"i2", NumberType::kInt16},   {"u2", NumberType::kUint16}, {"i4", NumberType::kInt32},
      {"u4", NumberType::kUint32},  {"i8", NumberType::kInt64},  {"u8", NumberType::kUint64},
      {"f4", NumberType::kFloat32}, {"f8", NumberType::kFloat64}};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

class NumpyReader {
 public:
  explicit NumpyReader(const Source& source) : source_(source), cursor_(source.bytes) {}

  std::vector<double> read() {
    read_header();
    const std::string_view descr = quoted_after("'descr':");
    const std::string_view order = descr.substr(0, 1);
    const auto type = numpy_type(descr.substr(order.size()));
    if (!type || (order != "<" && order != ">" && order != "|" && order != "=")) {
      fail(
          fmt::format("its numbers are of the type '{}'; expected whole numbers or real ones of "
                      "32 or 64 bits",
                      printable(descr)));
    }
    const std::uint64_t count = count_of_shape();
    const std::size_t size = size_of(*type);
    if (count != cursor_.left() / size || cursor_.left() % size != 0) {
      fail(fmt::format("its header announces {} numbers of {} bytes, but {} bytes follow", count,
                       size, cursor_.left()));
    }
    const bool little = std::endian::native == std::endian::little;
    const bool swap = (order == ">" && little) || (order == "<" && !little);
    std::vector<double> numbers;
    numbers.reserve(static_cast<std::size_t>(count));
    for (std::uint64_t k = 0; k < count; ++k) {
      numbers.push_back(load_number(*type, cursor_.take(size), swap));
    }
    return numbers;
  }

 private:
  void read_header() {
    using namespace std::string_view_literals;
    const bool big = std::endian::native == std::endian::big;
    if (!cursor_.rest().starts_with("\x93NUMPY"sv)) {
      fail("expected it to begin with \\x93NUMPY, as numpy.save() writes it");
    }
    cursor_.take(6);
    const char* version = take(2, "the version");
    if (version[0] < 1 || version[0] > 3) {
      fail(fmt::format("it is of version {}; expected 1, 2 or 3", int{version[0]}));
    }
    const std::size_t length = version[0] == 1
                                   ? load<std::uint16_t>(take(2, "the header's length"), big)
                                   : load<std::uint32_t>(take(4, "the header's length"), big);
    header_ = {take(length, "the header"), length};
  }

  const char* take(std::size_t bytes, const char* what) {
    const char* at = cursor_.take(bytes);
    if (at == nullptr) fail(fmt::format("it ends in {}", what));
    return at;
  }

  /// The text after a key of the header, without blanks.
  [[nodiscard]] std::string_view after(std::string_view key) const {
    const std::size_t at = header_.find(key);
    if (at == header_.npos) fail(fmt::format("expected {} in the header", key));
    std::string_view rest = header_.substr(at + key.size());
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    return rest;
  }

  [[nodiscard]] std::string_view quoted_after(std::string_view key) const {
    std::string_view rest = after(key);
    const std::size_t end = rest.starts_with("'") ? rest.find('\'', 1) : rest.npos;
    if (end == rest.npos) {
      fail(fmt::format("{} in the header is not one type of numbers (a table has several)", key));
    }
    return rest.substr(1, end - 1);
  }

  [[nodiscard]] std::uint64_t count_of_shape() const {
    std::string_view rest = after("'shape':");
    const std::size_t end = rest.starts_with("(") ? rest.find(')') : rest.npos;
    if (end == rest.npos) fail("expected the shape in brackets in the header");
    const std::string_view shape = rest.substr(1, end - 1);
    std::uint64_t count = 1;
    for (std::size_t at = 0; at < shape.size();) {
      if (shape[at] == ' ' || shape[at] == ',') {
        ++at;
        continue;
      }
      std::int64_t length = 0;
      const char* const last = shape.data() + shape.size();
      const auto [stop, error] = from_text(shape.data() + at, last, length);
      const bool possible =
          length >= 0 && static_cast<std::uint64_t>(length) <= source_.bytes.size();
      if (error != std::errc() || !possible || (count > 1 && length > 1)) {
        fail(fmt::format("its shape is ({}); expected one number for each vertex or face",
                         printable(shape)));
      }
      count *= static_cast<std::uint64_t>(length);
      at = static_cast<std::size_t>(stop - shape.data());
    }
    return count;
  }

  [[noreturn]] void fail(const std::string& what) const { cannot_read(source_.path, what); }

  const Source& source_;
  ByteCursor cursor_;
  std::string_view header_;
};

}  // namespace

std::vector<double> read_npy(const Source& source) { return NumpyReader(source).read(); }

}  // namespace talweg::formats
