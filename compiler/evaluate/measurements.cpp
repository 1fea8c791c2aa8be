#include "compiler/evaluate/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "compiler/units/format.hpp"

namespace toile {
namespace {

struct Measurement {
  std::string_view name;
  std::string_view also;  // the term of ISO 8559-1, then the names of other programs, separated by blanks
  double least, most;     // [m] from a newborn to the largest adults
};

// FreeSewing's in camel case, Valentina's with _circ and the like, GarmentCode's in lower case.
constexpr std::array measurements{
    Measurement{"height", "stature", 0.40, 2.50},
    Measurement{"neck", "neck_girth neck_base_girth neck_circ", 0.15, 0.80},
    Measurement{"bust", "bust_girth chest_girth chest bust_circ", 0.28, 2.20},
    Measurement{"underbust", "under_bust_girth lowbust_circ", 0.28, 2.00},
    Measurement{"waist", "waist_girth waist_circ", 0.28, 2.20},
    Measurement{"top_hip", "top_hip_girth highhip_circ", 0.28, 2.30},
    Measurement{"hip", "hip_girth seat hip_circ", 0.28, 2.40},
    Measurement{"thigh", "thigh_girth upperLeg leg_thigh_upper_circ leg_circ", 0.15, 1.20},
    Measurement{"knee", "knee_girth leg_knee_circ", 0.10, 0.80},
    Measurement{"ankle", "ankle_girth leg_ankle_circ", 0.07, 0.50},
    Measurement{"upper_arm", "upper_arm_girth biceps arm_upper_circ", 0.08, 0.80},
    Measurement{"wrist", "wrist_girth arm_wrist_circ", 0.06, 0.35},
    Measurement{"armhole", "armscye_girth armscye_circ", 0.15, 0.90},
    Measurement{"back_length", "back_neck_point_to_waist neck_back_to_waist_b waist_line", 0.12, 0.65},
    Measurement{"shoulder", "shoulder_length", 0.03, 0.25},
    Measurement{"back_width", "across_back_width across_back_b", 0.12, 0.70},
    Measurement{"chest_width", "across_front_width across_chest_f", 0.12, 0.70},
    Measurement{"bust_width", "bust_point_width bustSpan bustpoint_to_bustpoint bust_points", 0.06, 0.45},
    Measurement{"sleeve_length", "arm_length shoulderToWrist arm_shoulder_tip_to_wrist_bent", 0.12, 0.90},
    Measurement{"waist_to_hip", "waistToSeat height_waist_side_to_hip hips_line", 0.05, 0.40},
    Measurement{"rise", "body_rise waistToUpperLeg rise_length_side_sitting", 0.08, 0.50},
    Measurement{"inseam", "inside_leg_height inside_leg leg_crotch_to_floor", 0.10, 1.30},
    Measurement{"waist_to_floor", "waist_height waistToFloor height_waist_side", 0.20, 1.60},
};

/// The first is no more than the second on any figure but a few.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> orders{{
    {"waist", "hip"},
    {"underbust", "bust"},
    {"neck", "waist"},
    {"thigh", "hip"},
    {"knee", "thigh"},
    {"ankle", "knee"},
    {"wrist", "upper_arm"},
    {"armhole", "bust"},
    {"back_length", "height"},
    {"sleeve_length", "height"},
    {"inseam", "height"},
    {"rise", "inseam"},
}};

bool is_word_of(std::string_view words, std::string_view name) {
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (words.substr(begin, end - begin) == name) return true;
    begin = end + 1;
  }
  return false;
}

const Measurement* measurement(std::string_view name) {
  const auto found = std::ranges::find_if(measurements, [name](const Measurement& each) {
    return each.name == name || (!name.empty() && is_word_of(each.also, name));
  });
  return found == measurements.end() ? nullptr : &*found;
}

/// A length that is known.
const Quantity* length_of(const Measured& measured) {
  const auto* quantity = measured.value.known() ? measured.value.as<Quantity>() : nullptr;
  return quantity != nullptr && quantity->dimension == dimension::length ? quantity : nullptr;
}

const Measured* find(const std::vector<Measured>& measures, std::string_view name) {
  const auto found =
      std::ranges::find_if(measures, [name](const Measured& each) { return measurement_called(each.name) == name; });
  return found == measures.end() || length_of(*found) == nullptr ? nullptr : &*found;
}

}  // namespace

std::string_view measurement_called(std::string_view name) {
  const Measurement* known = measurement(name);
  return known == nullptr ? std::string_view{} : known->name;
}

bool same_measurement(std::string_view a, std::string_view b) {
  return a == b || (!measurement_called(a).empty() && measurement_called(a) == measurement_called(b));
}

std::string advice_on_measurement(std::string_view name) {
  if (name != "hips") return "";
  return "`hips` is the fullest girth in GarmentCode and the upper one in FreeSewing: write `hip` or `top_hip`";
}

bool check_measurements(Session& session, const std::string& whose, const std::vector<Measured>& measures) {
  constexpr double beyond_people = 3;  // times larger or smaller than anybody: not even a doll's
  bool possible = true;
  std::vector<const Measured*> asked_about;
  for (const Measured& each : measures) {
    const Measurement* known = measurement(each.name);
    const Quantity* length = length_of(each);
    if (!each.given || known == nullptr || length == nullptr) continue;
    if (length->si >= known->least && length->si <= known->most) continue;
    asked_about.push_back(&each);
    const std::string people =
        fmt::format("people have {} to {}", format(metres(known->least)), format(metres(known->most)));
    if (length->si < known->least / beyond_people || length->si > known->most * beyond_people) {
      possible = false;
      session.report.add(Problem("E0403", fmt::format("{} cannot have `{}` {}", whose, each.name, format(*length)))
                             .at(each.at, length->si > 0 ? "is this in another unit?" : "a measurement is positive")
                             .help(people));
      continue;
    }
    session.report.add(
        Problem("W0411", fmt::format("{} has `{}` {}, and {}", whose, each.name, format(*length), people))
            .at(each.at, "is this in another unit?"));
  }
  const auto asked = [&](const Measured* each) { return std::ranges::find(asked_about, each) != asked_about.end(); };
  for (const auto& [lesser, greater] : orders) {
    const Measured* small = find(measures, lesser);
    const Measured* large = find(measures, greater);
    if (small == nullptr || large == nullptr || length_of(*small)->si <= length_of(*large)->si) continue;
    if ((!small->given && !large->given) || asked(small) || asked(large)) continue;
    session.report.add(
        Problem("W0410", fmt::format("{} has `{}` {} and `{}` {}", whose, small->name, format(*length_of(*small)),
                                     large->name, format(*length_of(*large))))
            .at(small->given ? small->at : large->at, fmt::format("`{}` is larger than `{}`", small->name, large->name))
            .help("are two columns or two digits swapped?"));
  }
  return possible;
}

}  // namespace toile
