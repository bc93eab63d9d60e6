// A file plan knows which files a command reads and writes, and checks them before any work.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace talweg::driver {

/// Every command registers the files that it reads and writes, and has them checked before it reads
/// anything. A file is recognised by any path, link and spelling; a file that does not exist yet is
/// identified by its folder.
class FilePlan {
 public:
  /// Throws for a name whose extension has no format, as check_curve_name() does.
  using NameCheck = void (*)(const std::filesystem::path&);

  /// Files registered after this call belong to this place in a list, such as "line 3"; `list` is
  /// the list's name.
  void at(const std::string& list, const std::string& place);
  /// Folders of outputs need not exist: the command makes them.
  void makes_folders() { makes_folders_ = true; }

  /// `what` is the option or argument that names the file. An empty path means no file.
  void reads(const std::string& what, const std::string& path);
  void reads(const std::string& what, const std::vector<std::string>& paths);
  /// `-` and `-.ENDING` are the standard output; `-` is only allowed if the format does not depend
  /// on the ending.
  void writes(const std::string& what, const std::string& path, NameCheck name_check = nullptr);
  void writes(const std::string& what, const std::vector<std::string>& paths, NameCheck name_check);
  /// Files PREFIX0ENDING, PREFIX1ENDING, ...; their number is not known yet.
  void writes_numbered(const std::string& what, const std::string& prefix,
                       const std::string& ending, NameCheck name_check = nullptr);

  /// Throws Error(kBadUsage) if an output is also an input or another output, or is the standard
  /// output without a format; Error(kBadFile) for endings as the checks do, and for problems found
  /// by check_writable(). If an output uses the standard output, later text for people goes to the
  /// standard error.
  void check() const;

 private:
  /// The identity of an existing file is its device and inode number; the identity of a new file is
  /// the nearest existing folder and the path from there.
  struct Identity {
    std::uint64_t device = 0, number = 0;
    std::string way;
    auto operator<=>(const Identity&) const = default;
  };
  struct File {
    std::string what, path, list, place;
    NameCheck name_check = nullptr;
    Identity identity;
    bool device = false;  ///< a terminal or /dev/null: writing to it destroys no data
  };
  /// The names FIRST0ENDING, FIRST1ENDING, ... in a folder.
  struct Numbered {
    std::size_t output;  ///< the first of them, in outputs_
    std::string folder, first, ending;
  };

  /// For each folder the length of the longest name that was tried successfully.
  using TriedNames = std::map<std::string, std::size_t>;

  [[nodiscard]] File file(const std::string& what, const std::string& path) const;
  static Identity identity_of(const std::string& path, bool& device);
  [[noreturn]] static void overwrites(const File& output, const File& input);
  [[noreturn]] static void written_twice(const File& earlier, const File& later);
  void check_collisions() const;
  void check_numbered() const;
  void check_target(const File& output, TriedNames& tried) const;

  std::vector<File> inputs_, outputs_;
  std::vector<Numbered> numbered_;
  std::string list_, place_;
  bool makes_folders_ = false;
};

}  // namespace talweg::driver
