// A zip archive holds files, stored or packed by deflate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace talweg::formats {

/// An archive in memory (PKWARE's APPNOTE.TXT; also with sizes of 64 bits). Offsets and sizes are
/// checked against the size of the file. All errors are Error(kBadFile).
class ZipArchive {
 public:
  /// Reads the directory. `path` and `bytes` must outlive the archive.
  ZipArchive(const std::filesystem::path& path, std::string_view bytes);

  [[nodiscard]] bool has(const std::string& name) const { return entries_.contains(name); }
  /// Unpacks a file, at most 2 GiB, and checks its checksum. Throws if the file is encrypted or
  /// damaged.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  struct Entry {
    unsigned flags = 0, method = 0;
    std::uint32_t sum = 0;
    std::uint64_t packed = 0, size = 0, offset = 0;
  };
  [[nodiscard]] std::uint64_t number(std::uint64_t at, std::size_t size) const;
  void read_directory(std::uint64_t at, std::uint64_t count);
  void widen(Entry& entry, std::uint64_t at, std::uint64_t length) const;
  [[nodiscard]] std::string_view packed_bytes(const Entry& entry) const;
  [[noreturn]] void fail(const std::string& what) const;

  const std::filesystem::path& path_;
  std::string_view bytes_;
  std::map<std::string, Entry> entries_;
};

}  // namespace talweg::formats
