#include "file_plan.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "output_file.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/system/files.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

namespace fs = std::filesystem;

/// The target of a link, even if it does not exist yet.
fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code failed;
  for (int k = 0; k < kMostLinks && fs::is_symlink(path, failed) && !fs::exists(path, failed);
       ++k) {
    const fs::path target = fs::read_symlink(path, failed);
    if (failed) break;
    path = path.parent_path() / target;  // an absolute target replaces the path
  }
  return path;
}

/// The nearest folder above a path that does not exist.
fs::path folder_above(fs::path path) {
  do {
    path = path.parent_path();
  } while (!file_status(path) && path.has_relative_path());
  return path;
}

bool is_digits(std::string_view text) {
  return !text.empty() && (text == "0" || text.front() != '0') &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether a name is FIRST followed by a number and ENDING.
bool is_numbered(std::string_view name, std::string_view first, std::string_view ending) {
  if (name.size() <= first.size() + ending.size()) return false;
  if (!name.starts_with(first) || !name.ends_with(ending)) return false;
  return is_digits(name.substr(first.size(), name.size() - first.size() - ending.size()));
}

std::string in_list(const std::string& list, const std::string& place) {
  return place.empty() ? "" : list + ", " + place + ": ";
}

}  // namespace

void FilePlan::at(const std::string& list, const std::string& place) {
  list_ = list;
  place_ = place;
}

FilePlan::Identity FilePlan::identity_of(const std::string& path, bool& device) {
  const auto of = [&](const FileStatus& status) {
    device = status.kind == FileKind::kDevice;
    return Identity{status.device, status.number, ""};
  };
  if (is_standard_output(path)) {
    const FileStatus standard = file_status(*stdout);
    return standard.device != 0 ? of(standard) : Identity{0, 0, "-"};
  }
  std::error_code failed;
  const fs::path full = behind_links(fs::absolute(path, failed));
  if (const auto status = file_status(full)) return of(*status);
  // A folder that will be made may be followed by "..": absent/../mesh.ply.
  fs::path plain = fs::weakly_canonical(full, failed);
  if (failed) plain = full.lexically_normal();
  if (const auto status = file_status(plain)) return of(*status);
  const fs::path folder = folder_above(plain);
  Identity identity;
  if (const auto status = file_status(folder)) identity = of(*status);
  device = false;
  identity.way = common_spelling(plain.lexically_relative(folder)).string();
  return identity;
}

FilePlan::File FilePlan::file(const std::string& what, const std::string& path) const {
  File file{what, path, list_, place_, nullptr, {}, false};
  file.identity = identity_of(path, file.device);
  return file;
}

void FilePlan::reads(const std::string& what, const std::string& path) {
  if (!path.empty()) inputs_.push_back(file(what, path));
}

void FilePlan::reads(const std::string& what, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) reads(what, path);
}

void FilePlan::writes(const std::string& what, const std::string& path, NameCheck name_check) {
  if (path.empty()) return;
  outputs_.push_back(file(what, path));
  outputs_.back().name_check = name_check;
}

void FilePlan::writes(const std::string& what, const std::vector<std::string>& paths,
                      NameCheck name_check) {
  for (const std::string& path : paths) writes(what, path, name_check);
}

void FilePlan::writes_numbered(const std::string& what, const std::string& prefix,
                               const std::string& ending, NameCheck name_check) {
  if (is_standard_output(prefix)) {
    throw Error(ErrorCode::kBadUsage,
                what + " writes several files here, but the standard output is a single file.");
  }
  const fs::path full(prefix + ending);
  const fs::path folder = full.has_parent_path() ? full.parent_path() : fs::path(".");
  const std::string first = fs::path(prefix).filename().string();
  numbered_.push_back({outputs_.size(), folder.string(), first, ending});
  const std::string zeroth = prefix + "0" + ending;
  writes(what, zeroth, name_check);
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name == fs::path(zeroth).filename() || !is_numbered(name, first, ending)) continue;
    writes(what, at->path().string(), name_check);
  }
}

void FilePlan::overwrites(const File& output, const File& input) {
  const std::string where = input.place.empty() ? "" : ", and " + input.place + " reads it";
  throw Error(ErrorCode::kBadUsage,
              fmt::format("{}{} {} would overwrite an input: it is the same file as {} {}{}.",
                          in_list(output.list, output.place), output.what, output.path, input.what,
                          input.path, where));
}

void FilePlan::written_twice(const File& earlier, const File& later) {
  const std::string of = earlier.place.empty() ? "" : " of " + earlier.place;
  throw Error(ErrorCode::kBadUsage,
              fmt::format("{}{} would be written twice, by {} {}{} and by {}.",
                          in_list(later.list, later.place), later.path, earlier.what, earlier.path,
                          of, later.what));
}

void FilePlan::check_collisions() const {
  std::map<Identity, const File*> read, written;
  for (const File& input : inputs_) read.emplace(input.identity, &input);
  bool is_device = false;
  const Identity null = identity_of(null_device(), is_device);
  const File* standard = nullptr;
  for (const File& output : outputs_) {
    const auto input = read.find(output.identity);
    if (input != read.end() && !output.device) overwrites(output, *input->second);
    if (is_standard_output(output.path)) {
      if (standard != nullptr) written_twice(*standard, output);
      standard = &output;
    }
    if (output.identity == null) continue;
    const auto [at, is_new] = written.emplace(output.identity, &output);
    if (!is_new) written_twice(*at->second, output);
  }
}

/// Finds outputs that do not exist yet and would have the name of a numbered output.
void FilePlan::check_numbered() const {
  for (const Numbered& numbered : numbered_) {
    bool device = false;
    const Identity folder = identity_of(numbered.folder, device);
    if (!folder.way.empty()) continue;  // check_target() reports the missing folder
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      const File& other = outputs_[k];
      if (k == numbered.output || other.identity.way.empty()) continue;
      if (other.identity.device != folder.device || other.identity.number != folder.number)
        continue;
      if (is_numbered(other.identity.way, numbered.first, numbered.ending)) {
        written_twice(other, outputs_[numbered.output]);
      }
    }
  }
}

void FilePlan::check_target(const File& output, TriedNames& tried) const {
  if (output.name_check != nullptr) {
    if (output.path == "-") {
      throw Error(
          ErrorCode::kBadUsage,
          fmt::format("{}{} - is the standard output, whose format must be given by an ending, "
                      "such as {} -.ply.",
                      in_list(output.list, output.place), output.what, output.what));
    }
    output.name_check(output.path);
  }
  if (is_standard_output(output.path)) return;
  std::error_code failed;
  if (makes_folders_) {
    const fs::path folder = fs::absolute(output.path, failed).parent_path();
    const fs::path above = file_status(folder) ? folder : folder_above(folder);
    if (above != folder) {
      const auto status = file_status(above);
      if (status && status->kind != FileKind::kFolder) {
        cannot_write(output.path, above.string() + " is not a directory");
      }
      if (!may_write(above)) cannot_write(output.path, reason_of(errno));
      return;
    }
  }
  // A trial creates a file. One trial per folder is enough, unless another name is longer.
  const fs::path path(output.path);
  const auto status = file_status(path);
  std::size_t& longest = tried[fs::absolute(path, failed).parent_path().string()];
  const std::size_t length = path.filename().string().size();
  const bool is_file = (!status || status->kind == FileKind::kRegular) &&
                       !fs::is_symlink(path, failed) && length > 0;
  if (is_file && length <= longest) return;
  check_writable(path);
  longest = std::max(longest, length);
}

void FilePlan::check() const {
  check_collisions();
  check_numbered();
  TriedNames tried;
  for (const File& output : outputs_) check_target(output, tried);
  bool device = false;
  const Identity standard = identity_of("-", device);
  for (const File& output : outputs_) {
    if (output.identity == standard) keep_text_from_standard_output();
  }
}

}  // namespace talweg::driver
