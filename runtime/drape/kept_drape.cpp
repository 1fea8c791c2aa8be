#include "runtime/drape/kept_drape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "runtime/drape/carry_over.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr std::string_view heading = "toile drape 1\n";
constexpr std::uint64_t most = 10'000'000;  // of anything in a file that is to be believed

class Writer {
 public:
  void number(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<char>((value >> shift) & 0xffU));
  }
  void number(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view text) {
    number(std::uint64_t{text.size()});
    bytes_ += text;
  }
  void triples(const std::vector<std::array<int, 3>>& triples) {
    for (const auto& triple : triples) {
      for (const int i : triple) number(static_cast<std::uint64_t>(i));
    }
  }
  std::string& bytes() { return bytes_; }

 private:
  std::string bytes_{heading};
};

/// Reads what Writer wrote; past the end everything is 0 and `ok` turns false.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    if (rest_.size() < 8) {
      ok_ = false;
      rest_ = {};
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i) value |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * i);
    rest_.remove_prefix(8);
    return value;
  }
  double real() {
    const auto value = std::bit_cast<double>(number());
    ok_ = ok_ && std::isfinite(value);
    return value;
  }
  /// A number of things of so many bytes each, no more than there is left to read.
  std::size_t count(std::size_t bytes_each) {
    const std::uint64_t count = number();
    ok_ = ok_ && count <= most && count * bytes_each <= rest_.size();
    return ok_ ? count : 0;
  }
  int below(std::size_t bound) {
    const std::uint64_t value = number();
    ok_ = ok_ && value < bound;
    return ok_ ? static_cast<int>(value) : 0;
  }
  std::string text() {
    const std::size_t size = count(1);
    std::string text(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return text;
  }
  bool whole() const { return ok_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

std::vector<std::array<int, 3>> triples(Reader& reader, std::size_t count, std::size_t bound) {
  std::vector<std::array<int, 3>> triples(count);
  for (auto& triple : triples) {
    for (int& i : triple) i = reader.below(bound);
  }
  return triples;
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

KeptDrape keep(const Garment& garment, const SewnMesh& mesh, const std::vector<Vec3>& positions) {
  KeptDrape kept{{}, mesh.p.points, mesh.p.triangles, {}, {}, positions};
  for (const Piece& piece : garment.pieces) kept.pieces.push_back(piece.name);
  for (const PieceId piece : mesh.p.piece_of_triangle) kept.piece_of_triangle.push_back(static_cast<int>(piece));
  for (const auto& triangle : mesh.s.triangles) kept.s_vertices.push_back(triangle);
  return kept;
}

std::optional<std::vector<Vec3>> start_from(const KeptDrape& kept, const Garment& garment, const SewnMesh& mesh) {
  std::vector<int> number_now(kept.pieces.size(), -1);
  for (std::size_t now = 0; now < garment.pieces.size(); ++now) {
    const auto found = std::ranges::find(kept.pieces, garment.pieces[now].name);
    if (found == kept.pieces.end()) return std::nullopt;
    number_now[static_cast<std::size_t>(found - kept.pieces.begin())] = static_cast<int>(now);
  }
  SewnMesh from;
  from.p.points = kept.points;
  from.p.warp_of_piece.resize(garment.pieces.size());
  for (std::size_t t = 0; t < kept.triangles.size(); ++t) {
    const int piece = number_now[index(kept.piece_of_triangle[t])];
    if (piece < 0) continue;
    from.p.triangles.push_back(kept.triangles[t]);
    from.p.piece_of_triangle.push_back(static_cast<PieceId>(piece));
    from.s.triangles.push_back(kept.s_vertices[t]);
  }
  return carry_over(from, kept.positions, mesh);
}

std::string to_bytes(const KeptDrape& kept) {
  Writer writer;
  writer.number(std::uint64_t{kept.pieces.size()});
  for (const std::string& piece : kept.pieces) writer.text(piece);
  writer.number(std::uint64_t{kept.points.size()});
  for (const Vec2 point : kept.points) {
    writer.number(point.x);
    writer.number(point.y);
  }
  writer.number(std::uint64_t{kept.positions.size()});
  for (const Vec3& at : kept.positions) {
    for (const double x : {at.x, at.y, at.z}) writer.number(x);
  }
  writer.number(std::uint64_t{kept.triangles.size()});
  writer.triples(kept.triangles);
  writer.triples(kept.s_vertices);
  for (const int piece : kept.piece_of_triangle) writer.number(static_cast<std::uint64_t>(piece));
  writer.number(checksum(writer.bytes()));
  return std::move(writer.bytes());
}

std::optional<KeptDrape> from_bytes(std::string_view bytes) {
  if (!bytes.starts_with(heading) || bytes.size() < heading.size() + 8) return std::nullopt;
  const std::string_view content = bytes.substr(0, bytes.size() - 8);
  if (Reader(bytes.substr(content.size())).number() != checksum(content)) return std::nullopt;
  Reader reader(content.substr(heading.size()));
  KeptDrape kept;
  kept.pieces.resize(reader.count(8));
  for (std::string& piece : kept.pieces) piece = reader.text();
  kept.points.resize(reader.count(16));
  for (Vec2& point : kept.points) {
    point.x = reader.real();
    point.y = reader.real();
  }
  kept.positions.resize(reader.count(24));
  for (Vec3& at : kept.positions) {
    at.x = reader.real();
    at.y = reader.real();
    at.z = reader.real();
  }
  const std::size_t triangles = reader.count(56);
  kept.triangles = triples(reader, triangles, kept.points.size());
  kept.s_vertices = triples(reader, triangles, kept.positions.size());
  for (std::size_t t = 0; t < triangles; ++t) kept.piece_of_triangle.push_back(reader.below(kept.pieces.size()));
  if (!reader.whole()) return std::nullopt;
  return kept;
}

}  // namespace toile
