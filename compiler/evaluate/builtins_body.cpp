// Primitive bodies and imported ones.
#include <fmt/format.h>

#include "compiler/evaluate/builtins.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

/// Reads the sizes of a body; after one that cannot be, `sound` is false.
class Sizes {
 public:
  explicit Sizes(const BuiltinCall& call) : call_(call) {}

  double positive(std::size_t i, const char* name) {
    const double size = call_.si(i);
    if (size <= 0) {
      call_.refuse("E0208",
                   fmt::format("the {} of a body must be positive, and this is {}", name, format(call_.value(i))), i);
      sound = false;
    }
    return size;
  }

  bool sound = true;

 private:
  const BuiltinCall& call_;
};

/// The two last parameters of every body.
void read_surface(const BuiltinCall& call, std::size_t first, BodySpec& spec, Sizes& sizes) {
  if (call.has(first)) spec.softness = sizes.positive(first, "softness");
  if (!call.has(first + 1)) return;
  spec.friction = call.si(first + 1);
  if (*spec.friction >= 0) return;
  call.refuse("E0208", "friction cannot be negative", first + 1);
  sizes.sound = false;
}

template <typename Shape>
Value made(const BuiltinCall& call, const char* name, Shape shape, std::size_t surface, Sizes& sizes) {
  auto body = std::make_shared<BodyInstance>();
  body->spec.name = name;
  body->spec.written = call.at;
  body->spec.shape = std::move(shape);
  read_surface(call, surface, body->spec, sizes);
  // A size that only a drape will tell, or one in a branch that is not taken, makes no body to be measured.
  if (!sizes.sound || !call.known) return Unknown{};
  return BodyValue{std::move(body)};
}

Value sphere(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  const double radius = sizes.positive(0, "radius");
  return made(call, "sphere", SphereSpec{radius, call.si_or(1, radius)}, 2, sizes);
}

Value cylinder(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  const double radius = sizes.positive(0, "radius");
  const double length = sizes.positive(1, "length");
  const bool upright = !call.has(3) || call.value(3).as<Truth>()->value;
  const double height = call.si_or(2, upright ? length / 2 : radius);
  return made(call, "cylinder", CylinderSpec{radius, length, height, upright}, 4, sizes);
}

Value disc(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  const double radius = sizes.positive(0, "radius");
  const double thickness = call.has(1) ? sizes.positive(1, "thickness") : 0.01;
  return made(call, "disc", DiscSpec{radius, thickness, call.si_or(2, 1.0)}, 3, sizes);
}

Value box(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  const double width = sizes.positive(0, "width");
  const double depth = sizes.positive(1, "depth");
  const double tall = sizes.positive(2, "height");
  return made(call, "box", BoxSpec{width, depth, tall, call.si_or(3, tall)}, 4, sizes);
}

Value plane(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  return made(call, "plane", PlaneSpec{call.si_or(0, 0)}, 1, sizes);
}

Value mesh(const BuiltinCall& call) {
  if (!call.known) return Unknown{};
  Sizes sizes(call);
  return made(call, "mesh", MeshSpec{call.value(0).as<Text>()->value, {}}, 1, sizes);
}

}  // namespace

std::vector<Builtin> body_builtins() {
  using enum Want;
  const auto with_surface = [](std::vector<BuiltinParameter> parameters) {
    parameters.push_back({"softness", Softness, true});
    parameters.push_back({"friction", Plain, true});
    return parameters;
  };
  return {
      {"sphere", with_surface({{"radius", Length}, {"height", Length, true}}), sphere},
      {"cylinder",
       with_surface({{"radius", Length}, {"length", Length}, {"height", Length, true}, {"upright", Truth, true}}),
       cylinder},
      {"disc", with_surface({{"radius", Length}, {"thickness", Length, true}, {"height", Length, true}}), disc},
      {"box", with_surface({{"width", Length}, {"depth", Length}, {"tall", Length}, {"height", Length, true}}), box},
      {"plane", with_surface({{"height", Length, true}}), plane},
      {"mesh", with_surface({{"path", Text}}), mesh},
  };
}

}  // namespace toile
