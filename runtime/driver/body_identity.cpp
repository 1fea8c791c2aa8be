#include <fmt/format.h>

#include <array>
#include <iterator>

#include "runtime/driver/world.hpp"

namespace toile {
namespace {

/// Appends numbers in their shortest form that reads back exactly.
class Writer {
 public:
  template <class... Numbers>
  void numbers(Numbers... values) {
    (fmt::format_to(std::back_inserter(text_), "{} ", values), ...);
  }
  /// The length first, so that no name can imitate what follows it.
  void name(const std::string& value) { fmt::format_to(std::back_inserter(text_), "{}:{} ", value.size(), value); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

struct ShapeWriter {
  Writer& out;

  void operator()(const FormSpec& form) const {
    for (const BodySection& section : form.sections) {
      out.name(section.name);
      out.numbers(section.level, section.girth, section.width_to_depth, section.forward, section.squareness);
    }
    for (const BodyLimb& limb : form.limbs) {
      out.numbers(static_cast<int>(limb.kind), limb.girth_root, limb.girth_tip, limb.length, limb.angle);
    }
  }
  void operator()(const SphereSpec& sphere) const { out.numbers(sphere.radius, sphere.height); }
  void operator()(const CylinderSpec& cylinder) const {
    out.numbers(cylinder.radius, cylinder.length, cylinder.height, cylinder.upright);
  }
  void operator()(const DiscSpec& disc) const { out.numbers(disc.radius, disc.thickness, disc.height); }
  void operator()(const BoxSpec& box) const { out.numbers(box.width, box.depth, box.tall, box.height); }
  void operator()(const PlaneSpec& plane) const { out.numbers(plane.height); }
  void operator()(const MeshSpec& mesh) const {
    out.name(mesh.path);
    for (const MeshSpec::Line& line : mesh.lines) {
      out.name(line.name);
      out.numbers(line.px, line.py, line.pz, line.nx, line.ny, line.nz);
    }
  }
};

}  // namespace

std::string identity(const BodySpec& spec) {
  Writer out;
  out.numbers(spec.shape.index(), spec.softness, spec.friction.value_or(-1));
  std::visit(ShapeWriter{out}, spec.shape);
  return out.take();
}

std::string identity(const ChartSpec& chart) {
  Writer out;
  const std::array<double, 3> nowhere{1e9, 1e9, 1e9}, centre = chart.centre.value_or(nowhere),
                                                      pole = chart.pole.value_or(nowhere);
  out.numbers(static_cast<int>(chart.map), chart.radius, chart.ease, chart.angle, chart.reach, chart.cut.value_or(1e9),
              centre[0], centre[1], centre[2], pole[0], pole[1], pole[2]);
  return out.take() + chart.line;
}

}  // namespace toile
