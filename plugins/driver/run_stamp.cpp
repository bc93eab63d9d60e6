#include "run_stamp.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

namespace fs = std::filesystem;

class Hash {
 public:
  Hash() { XXH3_128bits_reset(state_.get()); }
  void add(std::string_view bytes) {
    XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
  }
  [[nodiscard]] std::string text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_{XXH3_createState()};
};

std::string hash_of_file(const std::string& path) {
  constexpr std::size_t kBlock = 1 << 20;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return {};
  std::ifstream in(fs::path(path), std::ios::binary);
  Hash hash;
  for (std::vector<char> block(kBlock); in;) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash.add({block.data(), static_cast<std::size_t>(in.gcount())});
  }
  return in.eof() ? hash.text() : std::string();
}

/// The extension, which chooses the reader of a file.
std::string ending(const std::string& path) { return fs::path(path).extension().string(); }

/// The options that can change a result. A new option does not compile before it has a place here.
std::string options_text(const SmoothOptions& options) {
  const auto& [mesh, repair, curves, labels, mesh_units, independent, outputs, written, report,
               potential, engine, distance, slack_field, max_deviation, heat_time, pins, corners,
               points, tolerance, click_distance, ends, border, ridges, repeat, tau, slack, finish,
               relax, budget, budget_work, threads] = options;
  std::vector<std::string> endings;
  endings.reserve(outputs.size());
  for (const std::string& output : outputs) endings.push_back(ending(output));
  const auto or_none = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "none";
  };
  return fmt::format(
      "{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}|{}",
      repair, !labels.empty(), mesh_units, independent, fmt::join(endings, ","), written.resample,
      written.normals, !report.empty(), potential, engine, or_none(max_deviation),
      or_none(heat_time), fmt::join(pins, ","), fmt::join(corners, ","), points, tolerance,
      or_none(click_distance), ends, border, ridges.strength, ridges.kind, or_none(ridges.band),
      repeat, fmt::join(tau, ","), fmt::join(slack, ","), fmt::join(finish, ","), relax,
      or_none(budget), or_none(budget_work));
}

/// The files that a run reads, in an order that tells them apart.
std::vector<std::string> files_of(const SmoothOptions& options) {
  std::vector<std::string> files = {options.mesh, options.labels, options.distance,
                                    options.slack_field};
  files.insert(files.end(), options.curves.begin(), options.curves.end());
  return files;
}

}  // namespace

std::string InputStamps::of_file(const std::string& path) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = files_.find(path); known != files_.end()) return known->second;
  }
  std::string hash = hash_of_file(path);
  const std::lock_guard lock(mutex_);
  return files_.emplace(path, std::move(hash)).first->second;
}

std::string InputStamps::of(const SmoothOptions& options) {
  Hash hash;
  hash.add(fmt::format("talweg {}|{}", version(), options_text(options)));
  for (const std::string& path : files_of(options)) {
    if (path.empty()) {
      hash.add("|none");
      continue;
    }
    const std::string contents = of_file(path);
    if (contents.empty()) return {};
    hash.add(fmt::format("|{} {}", ending(path), contents));
  }
  return hash.text();
}

std::string outputs_stamp(const SmoothOptions& options) {
  Hash hash;
  std::error_code ignored;
  for (const std::string& output : options.outputs) {
    const std::string contents = hash_of_file(output);
    if (contents.empty()) return {};
    hash.add("|" + contents);
  }
  if (!options.report.empty() && !fs::is_regular_file(options.report, ignored)) return {};
  return hash.text();
}

}  // namespace talweg::driver
