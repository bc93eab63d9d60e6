// Files that cannot be written: the error names the file, and an existing file stays.
#include "talweg/core/io/file_bytes.hpp"

#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/temporary_folder.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

class FileBytes : public TemporaryFolder {
 protected:
  static std::string refusal(const std::filesystem::path& path, std::string_view bytes) {
    try {
      write_file(path, bytes);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("."))) {
      count += entry.exists() ? 1 : 0;
    }
    return count;
  }
};

/// Limits the size of files during its lifetime, like a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(FileBytes, AFullDiskLeavesTheOldFileAndNothingBeside) {
  write("a.obj", "old");
  const std::string large(1 << 20, 'x');
  {
    const FullDisk full(1 << 16);
    EXPECT_NE(refusal(file("a.obj"), large), "");
    EXPECT_NE(refusal(file("new.obj"), large), "");
  }
  EXPECT_EQ(bytes_of(file("a.obj")), "old");
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(refusal(file("a.obj"), large), "");
  EXPECT_EQ(bytes_of(file("a.obj")), large);
}

TEST_F(FileBytes, DevicesAreWrittenInPlace) {
  EXPECT_EQ(refusal("/dev/null", "bytes"), "");
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "skipped: no /dev/full here";
  EXPECT_NE(refusal("/dev/full", "bytes"), "");
}

TEST_F(FileBytes, FoldersAndAbsentFoldersAreNamed) {
  std::filesystem::create_directory(file("folder"));
  EXPECT_NE(refusal(file("folder"), "bytes").find("directory"), std::string::npos);
  EXPECT_NE(refusal(file("absent/a.obj"), "bytes"), "");
  EXPECT_THROW(read_file(file("folder")), Error);
  EXPECT_THROW(read_file(file("absent")), Error);
  EXPECT_THROW(read_file(write("empty", "")), Error);
}

TEST_F(FileBytes, UnwritableFilesAreDetectedBefore) {
  const auto reason = [](const std::filesystem::path& path) -> std::string {
    try {
      check_writable(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      return error.what();
    }
    return "";
  };
  write("here", "old");
  std::filesystem::create_directory(file("folder"));
  for (const char* name : {"here", "new", "folder/new"}) EXPECT_EQ(reason(file(name)), "");
  for (const auto& path : {file("absent/a"), file("here/a"), file("folder"),
                           file(std::string(300, 'a')), file(std::string(250, 'a'))}) {
    EXPECT_EQ(reason(path), refusal(path, "bytes"));
    EXPECT_NE(reason(path), "");
  }
  EXPECT_NE(reason(file("folder/")), "");
  EXPECT_EQ(bytes_of(file("here")), "old");
  EXPECT_EQ(files(), 2U);
  EXPECT_EQ(reason("/dev/null"), "");
}

}  // namespace
}  // namespace talweg::test
