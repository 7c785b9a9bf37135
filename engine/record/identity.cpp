// What program, libraries and processor a run was made with.
#include <Eigen/Core>
#include <SuiteSparse_config.h>
#include <cholmod.h>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <hdf5.h>
#include <sys/utsname.h>
#include <thread>
#include <zlib.h>

#include "core/build_identity.hpp"
#include "record/manifest.hpp"

extern "C" char* openblas_get_corename();

namespace stiction::record {

namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

nlohmann::json libraries() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {
      {"eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"suitesparse", dotted(SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION)},
      {"cholmod", dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
      {"hdf5", fmt::format("{}.{}.{}", major, minor, release)},
      {"zlib", zlibVersion()}};
}

/// "model name" of /proc/cpuinfo, "unknown" elsewhere.
std::string read_processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (auto const colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown";
}

/// The name of the distribution, and of the kernel: "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64".
std::string operating_system() {
  std::string words;
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("PRETTY_NAME="))
      words = line.substr(line.find('=') + 1) + ", ";
  std::erase(words, '"');
  utsname own{};
  return uname(&own) == 0 ? words + fmt::format("{} {} {}", own.sysname, own.release, own.machine) : words;
}

} // namespace

std::string const& processor() { // the system takes its time to make that file
  static auto const found =
      fmt::format("{}, kernels of OpenBLAS: {}", read_processor(), openblas_get_corename());
  return found;
}

nlohmann::json host_facts() {
  return {{"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"system", operating_system()}};
}

std::string utc_now() {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
}

nlohmann::json build_identity() {
  auto const& identity = core::build_identity();
  return {{"version", identity.version}, {"commit", identity.commit},         {"compiler", identity.compiler},
          {"flags", identity.flags},     {"build_type", identity.build_type}, {"libraries", libraries()},
          {"processor", processor()}};
}

} // namespace stiction::record
