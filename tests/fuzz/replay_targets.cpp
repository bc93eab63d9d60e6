// fuzz_replay TARGET COUNT [FILE...] runs a target without a fuzzer: on the files, the seeds of the
// target, and COUNT changed copies of these. fuzz_replay --seeds TARGET FOLDER writes the seeds for
// libFuzzer. fuzz_replay --costs TARGET FILE... prints the costs of the files.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "cost_table.hpp"
#include "fuzz_target.hpp"

namespace talweg::fuzz {
namespace {

using Inputs = std::vector<std::string>;

void run(const Target& target, const std::string& bytes) {
  run(target, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// An input with a few changes like those of hostile or broken files.
std::string changed(const Inputs& inputs, std::mt19937& random) {
  static const char* const kWords[] = {"-1", "4294967295", "1e999", "nan", "99999999999999999999",
                                       "\n", "\r",         " ",     "\0",  "\xff\xff\xff\xff"};
  std::string bytes = inputs[random() % inputs.size()];
  for (std::size_t n = 1 + random() % 6; n > 0 && !bytes.empty(); --n) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1U << random() % 8));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.insert(at, kWords[random() % std::size(kWords)]);
        break;
      case 4:
        bytes.erase(at, 1 + random() % 8);
        break;
      default: {
        const std::string& other = inputs[random() % inputs.size()];
        if (!other.empty()) bytes.replace(at, 16, other, random() % other.size(), 32);
      }
    }
  }
  return bytes;
}

int write_seeds(const Target& target, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target.seeds(target)) {
    std::ofstream out(folder / ("seed" + std::to_string(number++)), std::ios::binary);
    out << seed;
    if (!out.flush()) return 1;
  }
  return 0;
}

int replay(const Target& target, int count, const Inputs& files) {
  Inputs inputs = target.seeds(target);
  const std::size_t seeds = inputs.size();
  for (const std::string& name : files) {
    std::ifstream in(name, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>{});
    std::printf("%s: %zu bytes\n", name.c_str(), inputs.back().size());
    std::fflush(stdout);
    run(target, inputs.back());
  }
  for (std::size_t k = 0; k < seeds; ++k) run(target, inputs[k]);
  std::mt19937 random(7);
  for (int k = 0; k < count; ++k) run(target, changed(inputs, random));
  std::printf("%s: %zu files, %zu seeds, %d changed\n", target.name.c_str(), files.size(), seeds,
              count);
  return 0;
}

}  // namespace
}  // namespace talweg::fuzz

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool seeds = words.size() == 3 && words[0] == "--seeds";
  const bool costs = words.size() >= 2 && words[0] == "--costs";
  const auto* target =
      words.size() < 2 ? nullptr : talweg::fuzz::target_named(words[seeds || costs ? 1 : 0]);
  if (target == nullptr) {
    std::fprintf(stderr,
                 "usage: fuzz_replay TARGET COUNT [FILE...] | --seeds TARGET FOLDER | "
                 "--costs TARGET FILE...\n");
    return 1;
  }
  const std::vector<std::string> files(words.begin() + 2, words.end());
  if (seeds) return talweg::fuzz::write_seeds(*target, words[2]);
  if (!costs) return talweg::fuzz::replay(*target, std::stoi(words[1]), files);
  talweg::fuzz::print_costs(files, [&](const std::uint8_t* data, std::size_t size) {
    return talweg::fuzz::run(*target, data, size);
  });
}
