#include "files.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace talweg::browser {
namespace {

/// A file that is removed with the object.
class Passing {
 public:
  explicit Passing(const std::string& name)
      : path_(std::filesystem::path(name).filename().string()) {
    if (path_.empty()) throw std::runtime_error("The file has no name.");
  }
  ~Passing() { static_cast<void>(std::remove(path_.c_str())); }
  Passing(const Passing&) = delete;
  Passing& operator=(const Passing&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

void with_file(const std::string& name, std::string_view bytes,
               const std::function<void(const std::string& path)>& use) {
  const Passing file(name);
  std::ofstream(file.path(), std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  use(file.path());
}

std::vector<std::uint8_t> written(const std::string& name,
                                  const std::function<void(const std::string& path)>& write) {
  const Passing file(name);
  write(file.path());
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace talweg::browser
