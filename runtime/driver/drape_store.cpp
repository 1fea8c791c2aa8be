#include "runtime/driver/drape_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "runtime/driver/files.hpp"

namespace toile {

namespace fs = std::filesystem;

fs::path DrapeStore::usual_folder() {
  // An empty variable counts as none (XDG Base Directory Specification).
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value != nullptr ? value : "");
  };
  fs::path caches = variable("XDG_CACHE_HOME");
  if (caches.empty() && !variable("HOME").empty()) caches = variable("HOME") / ".cache";
  std::error_code none;
  if (caches.empty()) caches = fs::temp_directory_path(none);
  return caches / "toile" / "drapes";
}

fs::path DrapeStore::file(const std::string& key) const {
  return folder_ / fmt::format("{:016x}.drape", checksum(key));
}

std::optional<KeptDrape> DrapeStore::find(const std::string& key) const {
  std::error_code failed;
  if (!fs::exists(file(key), failed)) return std::nullopt;
  std::string error;
  const std::optional<std::string> bytes = read_file(file(key), error);
  if (!bytes) return std::nullopt;
  fs::last_write_time(file(key), fs::file_time_type::clock::now(), failed);
  return from_bytes(*bytes);
}

void DrapeStore::keep(const std::string& key, const KeptDrape& drape) const {
  std::string error;
  if (write_file(file(key), to_bytes(drape), error)) make_room();
}

void DrapeStore::make_room() const {
  struct Kept {
    fs::file_time_type used;
    fs::path path;
    std::uintmax_t bytes;
  };
  std::vector<Kept> kept;
  std::error_code failed;
  for (fs::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed)) {
    if (at->path().extension() != ".drape") continue;
    std::error_code gone;
    const auto used = at->last_write_time(gone);
    const auto bytes = at->file_size(gone);
    if (!gone) kept.push_back({used, at->path(), bytes});
  }
  std::ranges::sort(kept, [](const Kept& a, const Kept& b) { return a.used > b.used; });
  std::uintmax_t sum = 0;
  for (const Kept& one : kept) {
    sum += one.bytes;
    if (sum > most_bytes_) fs::remove(one.path, failed);
  }
}

}  // namespace toile
