#include "talweg/core/io/vtk_data_array.hpp"

#include <stdexcept>

#include <zlib.h>

#include "talweg/core/io/base64.hpp"

namespace talweg::formats {
namespace {

constexpr std::uint64_t kLargestArray = std::uint64_t{1} << 31U;

/// Takes bytes from the front of raw or base64 data. Base64 data may continue after padding,
/// because writers encode a block's header and its data separately.
class ByteStream {
 public:
  ByteStream(std::string_view stored, bool base64) : stored_(stored), base64_(base64) {}

  /// An upper bound on the number of bytes left.
  [[nodiscard]] std::size_t at_most() const {
    return base64_ ? pending_.size() + (stored_.size() - at_) / 4 * 3 : stored_.size() - at_;
  }

  std::string take(std::uint64_t bytes) {
    if (bytes > at_most()) throw std::runtime_error("the data ends too early");
    const auto n = static_cast<std::size_t>(bytes);
    if (!base64_) {
      at_ += n;
      return std::string(stored_.substr(at_ - n, n));
    }
    pending_.reserve(n + 3);
    while (pending_.size() < n) {
      if (!decode_plain_quad()) decode_quad();
    }
    std::string result = pending_.substr(0, n);
    pending_.erase(0, n);
    return result;
  }

 private:
  char next_character() {
    while (at_ < stored_.size() &&
           std::string_view(" \t\r\n").find(stored_[at_]) != std::string_view::npos) {
      ++at_;
    }
    if (at_ == stored_.size()) throw std::runtime_error("the data ends too early");
    return stored_[at_++];
  }

  /// Four digits without blanks or padding; false for anything else.
  bool decode_plain_quad() {
    if (stored_.size() - at_ < 4) return false;
    std::uint32_t bits = 0;
    int all = 0;
    for (const char c : stored_.substr(at_, 4)) {
      const int digit = base64_digit(c);
      all |= digit;  // negative if any digit is
      bits = bits << 6U | static_cast<std::uint32_t>(digit & 63);
    }
    if (all < 0) return false;
    at_ += 4;
    const char bytes[] = {static_cast<char>(bits >> 16U), static_cast<char>(bits >> 8U),
                          static_cast<char>(bits)};
    pending_.append(bytes, sizeof bytes);
    return true;
  }

  void decode_quad() {
    std::uint32_t bits = 0;
    int padding = 0;
    for (int k = 0; k < 4; ++k) {
      const char c = next_character();
      const int digit = base64_digit(c);
      if (c == '=' && k >= 2) {
        ++padding;
      } else if (digit < 0 || padding > 0) {
        throw std::runtime_error("the data is not base64");
      }
      bits = bits << 6 | static_cast<std::uint32_t>(digit < 0 ? 0 : digit);
    }
    for (int k = 0; k < 3 - padding; ++k) {
      pending_.push_back(static_cast<char>(bits >> (16 - 8 * k) & 0xFFU));
    }
  }

  std::string_view stored_;
  bool base64_;
  std::size_t at_ = 0;
  std::string pending_;
};

std::uint64_t size_word(ByteStream& stream, const VtkEncoding& encoding) {
  if (encoding.wide_header) return load<std::uint64_t>(stream.take(8).data(), encoding.swap);
  return load<std::uint32_t>(stream.take(4).data(), encoding.swap);
}

std::string inflated(const std::string& packed, std::uint64_t size) {
  std::string result;
  // Deflate cannot compress better than about 1032 : 1.
  if (size / 1040 > packed.size() + 1 || size > result.max_size()) {
    throw std::runtime_error("a block's size is impossible");
  }
  result.resize(static_cast<std::size_t>(size));
  auto length = static_cast<uLongf>(size);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                 reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  if (status != Z_OK || length != size) throw std::runtime_error("the data is not valid zlib data");
  return result;
}

}  // namespace

std::string decoded_block(const VtkEncoding& encoding, std::string_view stored, bool base64) {
  ByteStream stream(stored, base64);
  const std::uint64_t first = size_word(stream, encoding);
  if (!encoding.compressed) return stream.take(first);
  if (first == 0) return {};
  const std::uint64_t block = size_word(stream, encoding);
  const std::uint64_t last = size_word(stream, encoding);
  if (first > stream.at_most()) throw std::runtime_error("the data ends too early");
  std::vector<std::uint64_t> packed_size(static_cast<std::size_t>(first));
  for (std::uint64_t& size : packed_size) size = size_word(stream, encoding);
  std::string result;
  for (std::size_t k = 0; k < packed_size.size(); ++k) {
    const bool partial = k + 1 == packed_size.size() && last > 0;
    const std::uint64_t size = partial ? last : block;
    // A small file may expand a thousandfold.
    if (size > kLargestArray - result.size()) {
      throw std::runtime_error("the data unpacks to more than 2 GiB");
    }
    result += inflated(stream.take(packed_size[k]), size);
  }
  return result;
}

std::vector<double> numbers_of(std::string_view bytes, NumberType type, bool swap) {
  const std::size_t size = size_of(type);
  if (bytes.size() % size != 0) {
    throw std::runtime_error(std::to_string(bytes.size()) +
                             " bytes are not a whole number of values");
  }
  std::vector<double> numbers(bytes.size() / size);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    numbers[k] = load_number(type, bytes.data() + k * size, swap);
  }
  return numbers;
}

}  // namespace talweg::formats
