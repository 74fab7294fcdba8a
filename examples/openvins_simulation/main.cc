// SPDX-License-Identifier: BSD-3-Clause
// openvins-simulation TRUE_CONFIG TRAJECTORY SEED CONFIG...: simulates one flight with the true calibration. OpenVINS'
// estimator estimates it with each of the others. Prints a line of CSV for each:
//   folder of CONFIG, metres flown, rms of the position (m) and of the orientation (deg), seconds of processor time
// "nan" where the filter broke.
#include "estimate.h"
#include "flight.h"
#include "trajectory_error.h"

#include <utils/print.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>

namespace {

std::string line_of(const flight::Flight& flight, const std::string& config) {
  const std::clock_t start = std::clock();
  const std::vector<flight::Pose> poses = flight::estimate(flight, config);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const flight::TrajectoryError error = flight::error_of(poses, flight.truth);
  char text[100];
  std::snprintf(text, sizeof text, "%.5f,%.5f,%.2f", error.position_m, error.orientation_deg, seconds);
  return text;
}

/// In a process of its own, as OpenVINS ends the program where its filter breaks.
std::string line_of_a_child(const flight::Flight& flight, const std::string& config) {
  int ends[2];
  if (pipe(ends) != 0) std::exit(EXIT_FAILURE);
  const pid_t child = fork();
  if (child == 0) {
    const std::string line = line_of(flight, config);
    const bool is_written = write(ends[1], line.data(), line.size()) == static_cast<ssize_t>(line.size());
    _exit(is_written ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  std::string line;
  char buffer[256];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;) line.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return line.empty() ? "nan,nan,nan" : line;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("usage: openvins-simulation TRUE_CONFIG TRAJECTORY SEED CONFIG...\n", stderr);
    return EXIT_FAILURE;
  }
  // OpenVINS prints on standard output, too: that goes to standard error.
  std::FILE* const out = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);
  ov_core::Printer::setPrintLevel("ERROR");

  const flight::Flight flight = flight::simulate({argv[1], argv[2], std::atoi(argv[3])});
  for (int i = 4; i < argc; ++i) {
    const std::string name = std::filesystem::path(argv[i]).parent_path().filename().string();
    const std::string line = line_of_a_child(flight, argv[i]);
    std::fprintf(out, "%s,%.2f,%s\n", name.c_str(), flight::length_of(flight), line.c_str());
    std::fflush(out);
  }
  return EXIT_SUCCESS;
}
