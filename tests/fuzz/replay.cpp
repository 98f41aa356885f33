// SPDX-License-Identifier: LGPL-2.1-or-later
// The targets without libFuzzer. Files or folders as arguments: each file is one input, as in the
// corpus that CTest replays. `--records`: inputs come on stdin, each after its length in bytes
// (four, little-endian); for each a line goes to stdout, "ok" or the refusal. mutate.py drives
// that. `--random SEED COUNT [FIRST]`: so many inputs of random bytes; which fail, and how many
// were accepted.
#include "fuzz/target.hpp"
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

namespace fs = std::filesystem;

namespace {

int replay_records() {
  std::array<unsigned char, 4> head{};
  while (std::cin.read(reinterpret_cast<char*>(head.data()), head.size())) {
    const std::size_t size =
        head[0] | head[1] << 8 | head[2] << 16 | static_cast<std::size_t>(head[3]) << 24;
    std::string input(size, '\0');
    if (!std::cin.read(input.data(), static_cast<std::streamsize>(size))) return 2;
    const std::string message = outcome_of(input);
    std::cout << (message.empty() ? "ok" : message) << '\n' << std::flush;
  }
  return 0;
}

std::string random_input(unsigned long seed, unsigned long number) {
  std::seed_seq both{seed, number};
  std::mt19937 engine(both);
  std::string input(600, '\0');
  for (char& byte : input) byte = static_cast<char>(engine() & 0xffU);
  return input;
}

int replay_random(unsigned long seed, unsigned long first, unsigned long count) {
  std::size_t failed = 0, accepted = 0;
  for (unsigned long number = first; number < first + count; ++number) {
    std::string message;
    try {
      message = outcome_of(random_input(seed, number));
      if (is_line_with_advice(message)) {
        accepted += message.empty() ? 1 : 0;
        continue;
      }
    } catch (const std::exception& error) {
      message = std::string("an exception that is no refusal: ") + error.what();
    }
    ++failed;
    std::cout << "seed " << seed << ", number " << number << ": " << message << '\n' << std::flush;
  }
  std::cout << count << " random inputs, " << accepted << " accepted, " << failed << " failed\n";
  return failed == 0 ? 0 : 1;
}

std::size_t replay(const fs::path& path) {
  if (fs::is_directory(path)) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(path)) count += replay(entry.path());
    return count;
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  const std::string input = text.str();
  std::cerr << path.string() << '\n';
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--records") return replay_records();
  if (argc >= 4 && std::string(argv[1]) == "--random")
    return replay_random(std::stoul(argv[2]), argc > 4 ? std::stoul(argv[4]) : 0,
                         std::stoul(argv[3]));
  std::size_t count = 0;
  for (int k = 1; k < argc; ++k) count += replay(argv[k]);
  std::cout << count << " inputs replayed\n";
  return count > 0 ? 0 : 2;
}
