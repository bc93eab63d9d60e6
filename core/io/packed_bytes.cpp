#include "talweg/core/io/packed_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <zlib.h>

namespace talweg::formats {
namespace {

constexpr std::uint8_t kNoDigit = 0xFF, kBlank = 0xFE;

std::array<std::uint8_t, 256> digit_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < kDigits.size(); ++k) {
    values[static_cast<unsigned char>(kDigits[k])] = static_cast<std::uint8_t>(k);
  }
  for (const char c : {' ', '\t', '\r', '\n'}) values[static_cast<unsigned char>(c)] = kBlank;
  return values;
}

}  // namespace

std::string from_base64(std::string_view text) {
  static const std::array<std::uint8_t, 256> kValues = digit_values();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int digits = 0;
  std::size_t at = 0;
  for (; at < text.size() && text[at] != '='; ++at) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(text[at])];
    if (value == kBlank) continue;
    if (value == kNoDigit) throw std::runtime_error("the data is not base64");
    bits = bits << 6U | value;
    if (++digits % 4 != 0) continue;
    bytes.push_back(static_cast<char>(bits >> 16U & 0xFFU));
    bytes.push_back(static_cast<char>(bits >> 8U & 0xFFU));
    bytes.push_back(static_cast<char>(bits & 0xFFU));
  }
  if (text.substr(std::min(at, text.size())).find_first_not_of("= \t\r\n") != text.npos) {
    throw std::runtime_error("the data goes on after the padding of its base64");
  }
  const int rest = digits % 4;
  if (rest == 1) throw std::runtime_error("the data is not base64");
  if (rest >= 2) bytes.push_back(static_cast<char>(bits >> (rest == 2 ? 4U : 10U) & 0xFFU));
  if (rest == 3) bytes.push_back(static_cast<char>(bits >> 2U & 0xFFU));
  return bytes;
}

std::string unpacked(std::string_view packed, std::size_t size) {
  // Deflate cannot compress better than about 1032 : 1.
  if (size / 1040 > packed.size() + 1) throw std::runtime_error("the data ends too early");
  z_stream stream{};
  constexpr int kZlibOrGzip = 15 + 32;
  if (inflateInit2(&stream, kZlibOrGzip) != Z_OK) throw std::runtime_error("zlib does not start");
  std::string bytes(size + 1, '\0');  // room for one byte too many, which is then noticed
  // zlib's input is not const, but is not written to.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (status != Z_STREAM_END && status != Z_BUF_ERROR) {
    throw std::runtime_error("the data is not valid zlib data");
  }
  if (status != Z_STREAM_END || stream.total_out != size) {
    throw std::runtime_error("the data unpacks to another number of bytes than is announced");
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace talweg::formats
