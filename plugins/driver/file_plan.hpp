// A file plan knows which files a command reads and writes, and checks them before any work.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace talweg::driver {

/// Every command tells what it reads and writes, and has it checked before it reads anything. The
/// same file is known by any path, link and spelling; one that is not there yet by its folder.
class FilePlan {
 public:
  /// Throws for a name with an ending that no format has; check_curve_name() and the like.
  using NameCheck = void (*)(const std::filesystem::path&);

  /// From now on files are of this place in a list, such as "line 3"; `list` is the list's name.
  void at(const std::string& list, const std::string& place);
  /// Folders of outputs need not be there: they are made.
  void makes_folders() { makes_folders_ = true; }

  /// `what` is the option or argument that names the file. An empty path is none.
  void reads(const std::string& what, const std::string& path);
  void reads(const std::string& what, const std::vector<std::string>& paths);
  /// `-` and `-.ENDING` are the standard output; where the ending chooses the format, the second.
  void writes(const std::string& what, const std::string& path, NameCheck name_check = nullptr);
  void writes(const std::string& what, const std::vector<std::string>& paths, NameCheck name_check);
  /// Files PREFIX0ENDING, PREFIX1ENDING, ...: nobody knows yet how many.
  void writes_numbered(const std::string& what, const std::string& prefix,
                       const std::string& ending, NameCheck name_check = nullptr);

  /// Throws Error(kBadUsage) where an output is an input or another output, or the standard output
  /// without a format; Error(kBadFile) for endings as the checks do, and for what check_writable()
  /// finds. Text for people leaves the standard output to outputs from here on.
  void check() const;

 private:
  /// A file that is there by its device and number there, another one by the nearest folder that
  /// is, and the way from it.
  struct Identity {
    std::uint64_t device = 0, number = 0;
    std::string way;
    auto operator<=>(const Identity&) const = default;
  };
  struct File {
    std::string what, path, list, place;
    NameCheck name_check = nullptr;
    Identity identity;
    bool device = false;  ///< a terminal, /dev/null: nothing is lost by writing it
  };
  /// Names in a folder: FIRST0ENDING, FIRST1ENDING, ...
  struct Numbered {
    std::size_t output;  ///< the first of them, in outputs_
    std::string folder, first, ending;
  };

  /// By folder the length of the longest name that could be written there.
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
