// Faults of the machine: full disks, absent folders, little memory, signals, a killed driver. Every
// file is the old or the new one, never half of one.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/generated_meshes.hpp"
#include "memory_limits.hpp"
#include "places.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

/// How often the tests below kill; TALWEG_KILLS for more.
int kills(int otherwise) {
  const char* wanted = std::getenv("TALWEG_KILLS");
  return wanted == nullptr ? otherwise : std::atoi(wanted);
}

class Faults : public DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), grid(30, 20));
    ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o drawn.obj").code, 0);
  }
  /// The driver, running, with nothing on its outputs.
  [[nodiscard]] pid_t start(const std::vector<std::string>& words) const {
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments{const_cast<char*>(driver_program())};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (chdir(file("").c_str()) != 0 || std::freopen("/dev/null", "w", stderr) == nullptr ||
        std::freopen("/dev/null", "w", stdout) == nullptr) {
      _exit(126);
    }
    execv(driver_program(), arguments.data());
    _exit(127);
  }
  static int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// A driver that waits for something, and what it ended with.
  struct Waiting {
    std::string name;
    pid_t id = 0;
    int status = 0;
    bool ended = false;

    [[nodiscard]] bool runs() {
      ended = ended || waitpid(id, &status, WNOHANG) != 0;
      return !ended;
    }
  };
  static void expect_end_by_signal(Waiting& child) {
    for (int k = 0; k < 200 && child.runs(); ++k) sleep_us(20'000);
    if (child.runs()) kill(child.id, SIGKILL);
    EXPECT_TRUE(WIFEXITED(child.status)) << child.name;
    EXPECT_EQ(WEXITSTATUS(child.status), 4) << child.name;
  }
  static void sleep_us(long us) { std::this_thread::sleep_for(std::chrono::microseconds(us)); }
};

TEST_F(Faults, AWriterThatIsKilledLeavesTheOldOrTheNewFile) {
  const std::string one(300'000, '1'), two(500'000, '2');
  write_file(file("out"), one);
  std::mt19937 random(1);
  for (int k = 0; k < kills(200); ++k) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) {
        write_file(file("out"), two);
        write_file(file("out"), one);
      }
    }
    sleep_us(static_cast<long>(random() % 4000));
    kill(child, SIGKILL);
    EXPECT_EQ(wait_for(child), -SIGKILL);
    const std::string now = bytes_of(file("out"));
    ASSERT_TRUE(now == one || now == two) << now.size() << " bytes after kill " << k;
  }
}

TEST_F(Faults, ADriverThatIsKilledLeavesTheOldOrTheNewResults) {
  const std::vector<std::string> outputs{"r.obj", "r.vtp", "r.json", "r.mrk.json"};
  const auto words = [&](const char* tau) {
    std::vector<std::string> all{"smooth", "mesh.ply", "--curve",  "drawn.obj",
                                 "--tau",  tau,        "--report", "report.json"};
    for (const std::string& output : outputs) all.insert(all.end(), {"-o", output});
    return all;
  };
  std::vector<std::vector<std::string>> good;  // of every tau, the bytes of every output
  long slowest = 0;
  for (const char* tau : {"4", "1"}) {
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(wait_for(start(words(tau))), 0);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, static_cast<long>(took.count()));
    good.emplace_back();
    for (const std::string& output : outputs) good.back().push_back(bytes_of(file(output)));
  }
  ASSERT_NE(good[0], good[1]);
  std::mt19937 random(2);
  int killed = 0;
  for (int k = 0; k < kills(40); ++k) {
    const pid_t child = start(words(k % 2 == 0 ? "4" : "1"));
    // Most of them near the end, where the writing is.
    sleep_us(slowest / 2 + static_cast<long>(random()) % (slowest / 2 + 1));
    kill(child, SIGKILL);
    killed += wait_for(child) == -SIGKILL ? 1 : 0;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const std::string now = bytes_of(file(outputs[i]));
      ASSERT_TRUE(now == good[0][i] || now == good[1][i]) << outputs[i] << " after kill " << k;
    }
    ASSERT_TRUE(nlohmann::json::accept(bytes_of(file("report.json")))) << "after kill " << k;
  }
  RecordProperty("killed", killed);
  EXPECT_GT(killed, 0);
}

TEST_F(Faults, SignalsEndARunWithCode4AndTheOldFile) {
  write_mesh(file("large.ply"), grid(400, 300));
  ASSERT_EQ(run("draw large.ply --through 1000,60000,119000 -o long.obj").code, 0);
  write("out.obj", "old");
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = start({"smooth", "large.ply", "--curve", "long.obj", "--repeat", "1000",
                               "-o", "out.obj", "--report", "out.json"});
    sleep_us(1'500'000);
    kill(child, signal);
    EXPECT_EQ(wait_for(child), 4);
    EXPECT_EQ(bytes_of(file("out.obj")), "old");
    EXPECT_FALSE(std::filesystem::exists(file("out.json")));
  }
}

TEST_F(Faults, ASecondSignalEndsAtOnceAReadThatWaits) {
  const std::string pipe = file("pipe.ply");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const pid_t child = start({"info", "pipe.ply"});
  int status = 0;
  const auto runs = [&] { return waitpid(child, &status, WNOHANG) == 0; };
  // The pipe opens when the driver reads. Nothing is written, so the driver waits until it is
  // ended.
  int writer = -1;
  while (runs() && (writer = open(pipe.c_str(), O_WRONLY | O_NONBLOCK)) < 0) sleep_us(10'000);
  kill(child, SIGTERM);
  kill(child, SIGINT);  // too soon to be meant as a second one
  sleep_us(200'000);
  EXPECT_TRUE(runs());
  for (int k = 0; k < 100 && runs(); ++k) {
    sleep_us(600'000);
    kill(child, SIGTERM);
    sleep_us(100'000);
  }
  if (runs()) kill(child, SIGKILL);
  close(writer);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(Faults, ASecondSignalEndsAPluginThatNeverReturns) {
  ASSERT_EQ(setenv("TALWEG_PLUGIN_PATH", toy_folder(), 1), 0);
  std::vector<Waiting> children;
  for (const char* fault : {"never_opens", "never_runs"}) {
    children.push_back({fault, start({"run", "toy.hostile", "mesh.ply", "--curve", "drawn.obj",
                                      "--fault", fault, "-o", "out.obj"})});
  }
  sleep_us(1'000'000);
  for (Waiting& child : children) kill(child.id, SIGINT);
  sleep_us(700'000);
  for (Waiting& child : children) {
    EXPECT_TRUE(child.runs()) << child.name;
    kill(child.id, SIGINT);
  }
  for (Waiting& child : children) expect_end_by_signal(child);
  EXPECT_FALSE(std::filesystem::exists(file("out.obj")));
  unsetenv("TALWEG_PLUGIN_PATH");
}

TEST_F(Faults, APipeWithoutAReaderIsLeftAtTheFirstSignal) {
  for (const char* pipe : {"1.json", "2.json", "3.json", "4.json"}) {
    ASSERT_EQ(mkfifo(file(pipe).c_str(), 0600), 0);
  }
  const std::vector<std::vector<std::string>> lines = {
      {"draw", "mesh.ply", "--through", "64,400", "-o", "1.json"},
      {"smooth", "mesh.ply", "--curve", "drawn.obj", "--report", "2.json"},
      {"smooth", "mesh.ply", "--curve", "drawn.obj", "--summary", "s.csv", "-o", "3.json"},
      {"cut", "mesh.ply", "--curve", "drawn.obj", "-o", "cut.ply", "--map", "4.json"}};
  std::vector<Waiting> children;
  for (const std::vector<std::string>& words : lines) children.push_back({words[0], start(words)});
  sleep_us(1'000'000);
  for (Waiting& child : children) {
    EXPECT_TRUE(child.runs()) << child.name;  // it waits for a reader
    kill(child.id, SIGINT);
  }
  for (Waiting& child : children) expect_end_by_signal(child);
}

TEST_F(Faults, APipeWhoseReaderDoesNotReadIsLeftAtTheFirstSignal) {
  const std::string pipe = file("pipe.ply");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  write_mesh(file("large.ply"), grid(100, 80));  // more bytes than a pipe takes
  write("edge.txt", "0\n1\n2\n");
  const pid_t child = start({"cut", "large.ply", "--curve", "edge.txt", "-o", "pipe.ply"});
  const int reader = open(pipe.c_str(), O_RDONLY);  // waits for the writer
  sleep_us(300'000);
  kill(child, SIGINT);
  int status = 0;
  const auto runs = [&] { return waitpid(child, &status, WNOHANG) == 0; };
  for (int k = 0; k < 200 && runs(); ++k) sleep_us(20'000);
  if (runs()) kill(child, SIGKILL);
  close(reader);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(Faults, APipeWithAReaderGetsAllBytes) {
  const std::string pipe = file("pipe.json");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.obj -o plain.json").code, 0);
  const pid_t child = start({"smooth", "mesh.ply", "--curve", "drawn.obj", "-o", "pipe.json"});
  EXPECT_EQ(bytes_of(pipe), bytes_of(file("plain.json")));  // waits for the writer
  EXPECT_EQ(wait_for(child), 0);
}

TEST_F(Faults, OutputsThatCannotBeWrittenAreNamed) {
  const std::string smooth = "smooth mesh.ply --curve drawn.obj ";
  expect_failure(smooth + "-o absent/out.obj", 2, {"absent/out.obj", "No such file"});
  expect_failure(smooth + "--report mesh.ply/r.json", 2, {"mesh.ply/r.json", "Not a directory"});
  expect_failure(smooth + "-o out.obj --report .", 2, {".", "directory"});
  expect_failure("draw mesh.ply --through 64,400 -o absent/d.txt", 2, {"absent/d.txt"});
  if (geteuid() != 0) {  // root may write anywhere
    std::filesystem::create_directory(file("locked"));
    write("locked/out.obj", "old");
    std::filesystem::permissions(
        file("locked"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expect_failure(smooth + "-o locked/out.obj", 2, {"locked/out.obj", "Permission denied"});
    EXPECT_EQ(bytes_of(file("locked/out.obj")), "old");
    std::filesystem::permissions(file("locked"), std::filesystem::perms::owner_all);
  }
}

TEST_F(Faults, AFullDiskIsAnErrorAlsoForWhatIsPrinted) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "skipped: no /dev/full here";
  expect_failure("smooth mesh.ply --curve drawn.obj --report /dev/full", 2,
                 {"/dev/full", "No space left"});
  // The shell ignores the redirection that run() appends after the #.
  EXPECT_EQ(run("info mesh.ply --json >/dev/full 2>err.log #").code, 2);
  EXPECT_NE(bytes_of(file("err.log")).find("standard output"), std::string::npos);
}

TEST_F(Faults, FilesThatWouldBeTooLargeLeaveTheOldOnes) {
  write("out.obj", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit little = before;
  little.rlim_cur = 512;
  setrlimit(RLIMIT_FSIZE, &little);
  const Outcome outcome = run("smooth mesh.ply --curve drawn.obj -o out.obj");
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("out.obj: File too large"), std::string::npos) << outcome.err;
  EXPECT_EQ(bytes_of(file("out.obj")), "old");
}

TEST_F(Faults, AFileThatChangesWhileItIsReadIsRefused) {
  // Another process keeps changing the size of the file while read_file() reads it.
  std::filesystem::resize_file(write("big.obj", "v 0 0 0\n"), 200'000'000);
  const pid_t child = fork();
  if (child == 0) {
    for (std::uintmax_t size = 150'000'000;; size ^= 1) {
      std::filesystem::resize_file(file("big.obj"), size);
    }
  }
  sleep_us(20'000);
  std::string what;
  try {
    static_cast<void>(read_file(file("big.obj")));
  } catch (const Error& error) {
    what = error.what();
  }
  kill(child, SIGKILL);
  wait_for(child);
  EXPECT_NE(what.find("big.obj: it changed while it was being read."), std::string::npos) << what;
}

TEST_F(Faults, LittleMemoryIsASentenceAndCode5) {
  if (!kMemoryCanBeLimited) GTEST_SKIP() << "skipped: a sanitizer needs all addresses";
  const std::string libraries = run("--version").out;
  if (libraries.find("openblas-pthread") != std::string::npos ||
      libraries.find("openblas-openmp") != std::string::npos) {
    GTEST_SKIP() << "skipped: threads of OpenBLAS wait for memory forever (libopenblas0-serial)";
  }
  write_mesh(file("large.ply"), grid(500, 400));
  write("curve.txt", "100\n101\n102\n103\n");
  write("out.obj", "old");
  int refused = 0;
  for (int mib = 60; mib <= 200; mib += 10) {
    const Outcome outcome = run("smooth large.ply --curve curve.txt -o out.obj",
                                "ulimit -v " + std::to_string(1024 * mib));
    if (outcome.code == 0) continue;
    ++refused;
    EXPECT_EQ(outcome.code, 5) << mib << " MiB: " << outcome.err;
    EXPECT_NE(outcome.err.find("memory"), std::string::npos) << mib << " MiB: " << outcome.err;
    EXPECT_EQ(bytes_of(file("out.obj")), "old");
  }
  EXPECT_GT(refused, 2);
}

}  // namespace
}  // namespace talweg::test
