#include "runtime/develop/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "runtime/develop/chart.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double sewn_apart = 0.002;  // [m] farther from each other than this, edges do not lie on one another

std::string place_text(Vec2 place) {
  return fmt::format("({:.1f} cm, {:.1f} cm)", 100 * place.x, 100 * place.y);
}

class TargetFinder {
 public:
  TargetFinder(const Garment& garment, const SewnMesh& mesh, const Body& body)
      : garment_(garment), mesh_(mesh), body_(body) {}

  Target find() {
    for (const Piece& piece : garment_.pieces) {
      if (!piece.chart) {
        target_.troubles.push_back({"piece `" + piece.drawn_name + "` is not drawn on the body", "", piece.written});
        continue;
      }
      std::string error;
      charts_.push_back(std::make_unique<BodyChart>(body_, *piece.chart, error));
      if (!error.empty()) target_.troubles.push_back({error, "", piece.chart->written});
    }
    if (!target_.troubles.empty()) return std::move(target_);
    target_.chart = mesh_.p.points;
    close_darts();
    find_positions();
    find_folded_triangles();
    return std::move(target_);
  }

 private:
  const Piece& piece_of(int point) const { return garment_.pieces[index(mesh_.p.piece_of_point[index(point)])]; }

  void close_darts() {
    for (std::size_t s = 0; s < garment_.seams.size(); ++s) {
      if (!garment_.seams[s].is_dart) continue;
      for (const PMesh::SewnRun& run : mesh_.p.sewn[s]) {
        for (std::size_t i = 0; i < run.first.size(); ++i) {
          Vec2 &a = target_.chart[index(run.first[i])], &b = target_.chart[index(run.second[i])];
          a = b = 0.5 * (a + b);
        }
      }
    }
  }

  void find_positions() {
    target_.positions.resize(static_cast<std::size_t>(mesh_.s.vertex_count));
    for (std::size_t v = 0; v < target_.positions.size(); ++v) {
      const std::vector<int>& points = mesh_.s.p_of_s[v];
      std::optional<Vec3> place;
      for (const int point : points) {
        const std::optional<Vec3> found = on_body(point);
        if (!found) continue;
        if (!place) place = found;
        const double apart = distance(*place, *found);
        if (apart > sewn_apart) note_apart(points.front(), point, apart);
      }
      if (place) target_.positions[v] = *place;
    }
  }

  std::optional<Vec3> on_body(int point) {
    const int piece = mesh_.p.piece_of_point[index(point)];
    const Vec2 place = target_.chart[index(point)];
    const BodyChart::Meeting meeting = charts_[index(piece)]->at(place);
    if (meeting.times != 1) note_missed(piece, place, meeting.times);
    return meeting.times > 0 ? std::optional(meeting.point) : std::nullopt;
  }

  /// One word a piece: its other places fail with it.
  void note_missed(int piece, Vec2 place, int times) {
    const Piece& drawn = garment_.pieces[index(piece)];
    if (!missed_.emplace(drawn.drawn_name, 0).second) return;
    const std::string at = fmt::format("piece `{}` at {}", drawn.drawn_name, place_text(place));
    if (times == 0) {
      target_.troubles.push_back(drawn.chart->map == ChartSpec::Map::Conformal
                                     ? Target::Trouble{at + " lies beyond the part of the body that its map shows",
                                                       "give the map more reach, or keep the outline inside",
                                                       drawn.written}
                                     : Target::Trouble{at + " lies beyond the body: nothing is met there",
                                                       "keep the outline on the body", drawn.written});
    } else {
      target_.troubles.push_back(
          {fmt::format("{} meets the body {} times: its chart is not one to one there", at, times),
           "keep clear of limbs, or draw the piece about the axis of another line: piece sleeve on form.left_armhole",
           drawn.written});
    }
  }

  void note_apart(int first, int second, double apart) {
    const Piece &a = piece_of(first), &b = piece_of(second);
    if (!apart_.emplace(a.name + "/" + b.name, 0).second) return;
    target_.troubles.push_back(
        {fmt::format("`{}` and `{}` are sewn together where they lie {:.1f} mm apart on the body", a.name, b.name,
                     1000 * apart),
         "pieces that are sewn share a line of the body: draw it alike in both", b.written});
  }

  /// Where the surface is steep along the rays the chart may be one to one and still fold triangles over each other.
  void find_folded_triangles() {
    for (std::size_t t = 0; t < mesh_.p.triangles.size(); ++t) {
      const std::array<int, 3>& corners = mesh_.p.triangles[t];
      const Vec2 a = target_.chart[index(corners[0])], b = target_.chart[index(corners[1])],
                 c = target_.chart[index(corners[2])];
      if (cross(b - a, c - a) > 0) continue;
      const Piece& piece = piece_of(corners[0]);
      if (!missed_.emplace(piece.drawn_name, 0).second) return;
      target_.troubles.push_back({fmt::format("a dart of piece `{}` is too short for the mesh", piece.drawn_name),
                                  "make it deeper", piece.written});
    }
  }

  const Garment& garment_;
  const SewnMesh& mesh_;
  const Body& body_;
  std::vector<std::unique_ptr<BodyChart>> charts_;
  std::map<std::string, int> missed_, apart_;
  Target target_;
};

}  // namespace

Target find_target(const Garment& garment, const SewnMesh& mesh, const Body& body) {
  return TargetFinder(garment, mesh, body).find();
}

}  // namespace toile
