// The cache of drapes that `--warm` starts from: files that may be deleted at any time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/drape/kept_drape.hpp"

namespace toile {

class DrapeStore {
 public:
  /// Below `folder`, which is made when something is kept first. It holds at most `most_bytes`: what was used longest
  /// ago goes first.
  explicit DrapeStore(std::filesystem::path folder, std::uintmax_t most_bytes = 256'000'000)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}
  /// `toile/drapes` in $XDG_CACHE_HOME, or in ~/.cache; without either, in the folder for temporary files.
  static std::filesystem::path usual_folder();

  /// What was kept last under this key; nullopt when there is nothing or it is damaged.
  std::optional<KeptDrape> find(const std::string& key) const;
  /// A cache that cannot be written is no error.
  void keep(const std::string& key, const KeptDrape& drape) const;

 private:
  std::filesystem::path file(const std::string& key) const;
  void make_room() const;

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
};

}  // namespace toile
