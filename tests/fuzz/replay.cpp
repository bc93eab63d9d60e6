// Runs the interface without a fuzzer: on files of the command line, and on generated inputs of a
// mesh, a drawing and random calls.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  for (int k = 2; k < argc; ++k) {
    std::ifstream in(argv[k], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    std::printf("%s: %zu bytes\n", argv[k], bytes.size());
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  const int count = argc > 1 ? std::stoi(argv[1]) : 0;
  std::mt19937 random(7);
  for (int k = 0; k < count; ++k) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    // The plugin, a valid mesh, a drawing along a row of the mesh; then arbitrary bytes.
    std::vector<std::uint8_t> bytes = {byte(), 0, 5, 0, 31, 31, 1, byte(), 5};
    for (int i = 0; i < 5; ++i) bytes.insert(bytes.end(), {9, byte(), byte(), byte()});
    bytes.insert(bytes.end(), {255, 1, 2, 31, 31, 0});
    for (std::size_t i = random() % 200; i > 0; --i) bytes.push_back(byte());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%d generated inputs\n", count);
}
