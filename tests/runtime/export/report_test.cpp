#include "runtime/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/report/summary.hpp"
#include "runtime/report/tightness.hpp"
#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The dotted names of all values, in the order of the file.
std::vector<std::string> keys(const OrderedJson& object, const std::string& prefix = "") {
  std::vector<std::string> all;
  for (const auto& [key, value] : object.items()) {
    if (!value.is_object()) {
      all.push_back(prefix + key);
      continue;
    }
    for (std::string& inner : keys(value, prefix + key + ".")) all.push_back(std::move(inner));
  }
  return all;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

TEST(Report, KeysAreThoseOfTheDocumentation) {
  const OrderedJson report = OrderedJson::parse(report_json("tube.toile", draped_tube().view()));
  EXPECT_EQ(keys(report), words(R"(
    schema script garment
    mesh.triangles mesh.vertices mesh.edges mesh.boundary_loops mesh.components mesh.euler mesh.orientable
    mesh.manifold mesh.area_m2 mesh.edge_length_m.min mesh.edge_length_m.mean mesh.edge_length_m.max
    solve.converged solve.trouble solve.iterations solve.residual_N solve.residual_moment_Nm
    solve.residual_relative solve.energy_J.stretch_warp solve.energy_J.stretch_weft solve.energy_J.shear
    solve.energy_J.bend_warp solve.energy_J.bend_weft solve.energy_J.twist solve.energy_J.gravity
    solve.energy_J.contact solve.energy_J.friction solve.energy_J.self_contact solve.energy_J.total
    contact.weight_N contact.support_N.body contact.support_N.friction contact.support_N.held
    contact.support_N.total contact.weight_error contact.max_penetration_m contact.contact_area_m2
    contact.pressure_Pa.mean contact.pressure_Pa.p95 contact.pressure_Pa.max
    contact.tightest.pressure_Pa contact.tightest.piece contact.tightest.at_m contact.tightest.thread
    contact.tightest.strain contact.tightest.length_m contact.tightest.short_m
    self.intersecting_triangle_pairs
    shape.folds shape.projected_area_m2
    strain.warp.min strain.warp.mean strain.warp.p95 strain.warp.max strain.weft.min strain.weft.mean
    strain.weft.p95 strain.weft.max strain.shear.min strain.shear.mean strain.shear.p95 strain.shear.max
    stress_N_per_m.warp.min stress_N_per_m.warp.mean stress_N_per_m.warp.p95 stress_N_per_m.warp.max
    stress_N_per_m.weft.min stress_N_per_m.weft.mean stress_N_per_m.weft.p95 stress_N_per_m.weft.max
    stress_N_per_m.shear.min stress_N_per_m.shear.mean stress_N_per_m.shear.p95 stress_N_per_m.shear.max
  )"));
}

TEST(Report, TellsWhatTheDrapeFound) {
  const OrderedJson report = OrderedJson::parse(report_json("tube.toile", draped_tube(5, 0.2).view()));
  EXPECT_EQ(report["schema"].get<int>(), 1);
  EXPECT_EQ(report["script"].get<std::string>(), "tube.toile");
  EXPECT_EQ(report["garment"].get<std::string>(), "tube");
  EXPECT_EQ(report["solve"]["converged"].get<bool>(), true);
  EXPECT_EQ(report["solve"]["iterations"].get<int>(), 41);
  EXPECT_EQ(report["solve"]["energy_J"]["total"].get<double>(), -0.25);
  EXPECT_EQ(report["contact"]["support_N"]["total"].get<double>(), 0.7);
  EXPECT_EQ(report["contact"]["max_penetration_m"].get<double>(), 3e-5);
  EXPECT_EQ(report["contact"]["pressure_Pa"]["max"].get<int>(), 30);
  EXPECT_EQ(report["self"]["intersecting_triangle_pairs"].get<int>(), 0);
  EXPECT_EQ(report["shape"]["folds"].get<int>(), 5);
}

TEST(Report, SaysHowMuchTooShortThePieceIsThatPressesHardest) {
  DrapedTube tube = draped_tube();
  const auto pressed = static_cast<std::size_t>(tube.cloth.triangles[0].vertices[0]);
  const PieceId piece = tube.mesh.p.piece_of_triangle[0];
  std::ranges::fill(tube.drape.pressure, 100.0);
  tube.drape.pressure[pressed] = 9000;
  std::ranges::fill(tube.drape.stress_weft, 500.0);
  std::ranges::fill(tube.drape.stress_warp, 1.0);
  std::ranges::fill(tube.drape.strain_weft, 0.05);
  const Tightness tight = tightest(tube.view());
  EXPECT_EQ(tight.pressure_Pa, 9000);
  EXPECT_EQ(tight.piece, piece);
  EXPECT_FALSE(tight.along_warp);
  EXPECT_DOUBLE_EQ(tight.strain, 0.05);
  // From side to side of the piece, sixty centimetres.
  EXPECT_NEAR(tight.length_m, kColumns * kSquare, 1e-9);
  EXPECT_NEAR(tight.short_m, 0.05 * kColumns * kSquare, 1e-9);
}

TEST(Report, SameDrapeSameBytes) {
  EXPECT_EQ(report_json("a.toile", draped_tube(4, 0.1).view()), report_json("a.toile", draped_tube(4, 0.1).view()));
}

TEST(Report, SurvivesNamesThatAreNoText) {
  EXPECT_TRUE(OrderedJson::accept(report_json("caf\xe9.toile", draped_tube().view())));
}

TEST(Summary, MeasuresTheMeshInThePattern) {
  const Summary summary = summarise(draped_tube(5, 0.2).view());  // the wave stretches the tube, not its pattern
  EXPECT_NEAR(summary.area_m2, 2 * 0.6 * 0.2, 1e-12);
  EXPECT_NEAR(summary.edge_min_m, kSquare, 1e-12);
  EXPECT_NEAR(summary.edge_max_m, kSquare * std::sqrt(2), 1e-12);
  EXPECT_GT(summary.edge_mean_m, summary.edge_min_m);
  EXPECT_LT(summary.edge_mean_m, summary.edge_max_m);
}

TEST(Summary, SpreadsWeighByArea) {
  const Summary summary = summarise(draped_tube().view());
  EXPECT_DOUBLE_EQ(summary.strain.warp.min, 0.01);
  EXPECT_DOUBLE_EQ(summary.strain.warp.max, 0.02);
  EXPECT_NEAR(summary.strain.warp.mean, 0.015, 1e-12);
  EXPECT_DOUBLE_EQ(summary.strain.shear.p95, 0.1);
  EXPECT_NEAR(summary.strain.shear.mean, 0, 1e-12);
  EXPECT_DOUBLE_EQ(summary.stress_N_per_m.weft.min, -0.5);
}

TEST(Profile, HasItsKeys) {
  const OrderedJson profile = OrderedJson::parse(profile_json({1, 2, 3, 4, 10, 17.5, 123456, 9}));
  EXPECT_THAT(keys(profile),
              testing::ElementsAre("schema", "seconds.compile", "seconds.mesh", "seconds.place", "seconds.solve",
                                   "seconds.total", "cpu_seconds", "peak_memory_bytes", "factorisations"));
  EXPECT_EQ(profile["cpu_seconds"].get<double>(), 17.5);
  EXPECT_EQ(profile["peak_memory_bytes"].get<int>(), 123456);
}

}  // namespace
}  // namespace toile
