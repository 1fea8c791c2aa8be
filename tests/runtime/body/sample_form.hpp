// A dress form of middling size for tests.
#pragma once

#include "compiler/pattern/body_spec.hpp"

namespace toile {

inline FormSpec sample_form() {
  FormSpec form;
  form.sections = {
      {"", 0.78, 0.921, 1.47, -0.018, 2.3},    {"hip", 0.813, 0.94, 1.43, -0.015, 2.3},
      {"", 0.914, 0.836, 1.39, -0.01, 2.25},   {"waist", 1.015, 0.68, 1.31, 0.005, 2.1},
      {"", 1.124, 0.748, 1.27, 0.01, 2.2},     {"bust", 1.196, 0.88, 1.18, 0.022, 2.35},
      {"", 1.261, 0.88, 1.47, 0.011, 2.4},     {"", 1.311, 0.862, 1.9, 0.001, 2.5},
      {"", 1.346, 0.818, 2.44, -0.006, 2.5},   {"", 1.373, 0.598, 1.98, -0.005, 2.3},
      {"neck", 1.40, 0.36, 1.11, -0.007, 2.1}, {"", 1.45, 0.331, 1.02, 0, 2},
  };
  form.limbs = {{BodyLimb::Kind::Arm, 0.40, 0.30, 0.11, 0.873}, {BodyLimb::Kind::Leg, 0.54, 0.243, 0.6435, 0.07}};
  return form;
}

inline BodySpec body_of(decltype(BodySpec::shape) shape) {
  BodySpec spec;
  spec.name = "body";
  spec.shape = std::move(shape);
  return spec;
}

}  // namespace toile
