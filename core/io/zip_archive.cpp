#include "talweg/core/io/zip_archive.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <zlib.h>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

constexpr std::uint64_t kLargest = std::uint64_t{1} << 31U;
constexpr std::uint64_t kEndSize = 22;
constexpr std::uint32_t kNarrow = 0xFFFFFFFFU;  // the extra field has the number, in 64 bits

/// Unpacks raw deflate data of known size; empty if the data are damaged.
std::string inflated(std::string_view packed, std::uint64_t size) {
  std::string result;
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return result;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  result.resize(static_cast<std::size_t>(size));
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(size);
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  if (!whole) result.clear();
  return result;
}

}  // namespace

ZipArchive::ZipArchive(const std::filesystem::path& path, std::string_view bytes)
    : path_(path), bytes_(bytes) {
  if (!bytes.starts_with("PK"))
    fail("this is not a zip archive: it does not begin with the letters PK");
  const std::size_t end = bytes.rfind("PK\x05\x06");
  if (end == std::string_view::npos || bytes.size() - end < kEndSize) {
    fail("the zip archive has no directory at its end, so it is cut off");
  }
  std::uint64_t count = number(end + 10, 2), at = number(end + 16, 4);
  if ((count == 0xFFFF || at == kNarrow) && end >= 20 && number(end - 20, 4) == 0x07064B50) {
    const std::uint64_t wide = number(end - 12, 8);
    if (number(wide, 4) != 0x06064B50) fail("the zip archive's directory is damaged");
    count = number(wide + 32, 8);
    at = number(wide + 48, 8);
  }
  read_directory(at, count);
}

std::uint64_t ZipArchive::number(std::uint64_t at, std::size_t size) const {
  if (at > bytes_.size() || size > bytes_.size() - at)
    fail("the zip archive's directory is damaged");
  const char* from = bytes_.data() + at;
  constexpr bool kSwap = std::endian::native == std::endian::big;
  if (size == 2) return load<std::uint16_t>(from, kSwap);
  return size == 4 ? load<std::uint32_t>(from, kSwap) : load<std::uint64_t>(from, kSwap);
}

void ZipArchive::read_directory(std::uint64_t at, std::uint64_t count) {
  for (std::uint64_t k = 0; k < count; ++k) {
    if (number(at, 4) != 0x02014B50) fail("the zip archive's directory is damaged");
    Entry entry;
    entry.flags = static_cast<unsigned>(number(at + 8, 2));
    entry.method = static_cast<unsigned>(number(at + 10, 2));
    entry.sum = static_cast<std::uint32_t>(number(at + 16, 4));
    entry.packed = number(at + 20, 4);
    entry.size = number(at + 24, 4);
    entry.offset = number(at + 42, 4);
    const std::uint64_t name = number(at + 28, 2), extra = number(at + 30, 2);
    const std::uint64_t next = at + 46 + name + extra + number(at + 32, 2);
    if (next > bytes_.size()) fail("the zip archive's directory is damaged");
    widen(entry, at + 46 + name, extra);
    entries_.emplace(
        bytes_.substr(static_cast<std::size_t>(at + 46), static_cast<std::size_t>(name)), entry);
    at = next;
  }
}

/// Reads numbers of 64 bits from the extra field, which holds, in this order, the numbers that do
/// not fit 32 bits.
void ZipArchive::widen(Entry& entry, std::uint64_t at, std::uint64_t length) const {
  const std::uint64_t end = at + length;
  while (at + 4 <= end) {
    const std::uint64_t id = number(at, 2), field_end = at + 4 + number(at + 2, 2);
    at += 4;
    for (std::uint64_t* value : {&entry.size, &entry.packed, &entry.offset}) {
      if (id != 1 || *value != kNarrow || at + 8 > field_end) continue;
      *value = number(at, 8);
      at += 8;
    }
    at = field_end;
  }
}

std::string_view ZipArchive::packed_bytes(const Entry& entry) const {
  if (number(entry.offset, 4) != 0x04034B50) fail("the zip archive's directory is damaged");
  const std::uint64_t from =
      entry.offset + 30 + number(entry.offset + 26, 2) + number(entry.offset + 28, 2);
  if (from > bytes_.size() || entry.packed > bytes_.size() - from) {
    fail("a file of the zip archive ends after the archive");
  }
  return bytes_.substr(static_cast<std::size_t>(from), static_cast<std::size_t>(entry.packed));
}

std::string ZipArchive::read(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) fail(fmt::format("the zip archive has no {}", printable(name)));
  const Entry& entry = found->second;
  const std::string_view packed = packed_bytes(entry);
  if ((entry.flags & 1U) != 0) fail(fmt::format("{} is encrypted", printable(name)));
  if (entry.method != 0 && entry.method != 8) {
    fail(fmt::format("{} is packed by method {}; only deflate is read", printable(name),
                     entry.method));
  }
  // Deflate cannot compress better than about 1032 : 1.
  if (entry.size > kLargest || entry.size / 1040 > packed.size() + 1) {
    fail(fmt::format("{} is said to have {} bytes, which is impossible or more than 2 GiB",
                     printable(name), entry.size));
  }
  std::string bytes = entry.method == 0 ? std::string(packed) : inflated(packed, entry.size);
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  if (bytes.size() != entry.size || crc32(0, data, static_cast<uInt>(bytes.size())) != entry.sum) {
    fail(fmt::format("{} in the zip archive is damaged", printable(name)));
  }
  return bytes;
}

void ZipArchive::fail(const std::string& what) const { cannot_read(path_, what); }

}  // namespace talweg::formats
