// What can be asked of a loaded script. Each function says what it did to the workroom's listener and leaves how it
// went in the workroom's outcome.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/driver/workroom.hpp"

namespace toile {

/// All commands of the script in order, each with the results of those before it.
void run_commands(Workroom& workroom);

/// Everything up to the meshes' topology, nothing solved: a line a garment.
void check_meshes(Workroom& workroom);

/// A stage of the compiler as stable text.
enum class Stage { Ast, Pattern, PMesh, SMesh, Sewing };
std::optional<Stage> stage_named(const std::string& name);
/// Nullopt when the script has no such garment, or several and none was named: that has then been said.
std::optional<std::string> emit_stage(Workroom& workroom, Stage stage, const std::string& garment);

/// The flat pattern to a file.
void draft(Workroom& workroom, const std::string& garment, const std::filesystem::path& file);
/// All sizes of a script, or those chosen, to one drawing: the last workroom writes it.
Outcome draft_nested(const std::filesystem::path& script, const WorkroomOptions& options, const std::string& garment,
                     const std::filesystem::path& file, Listener& listener, const Job& job);
/// The order of sewing to a file.
void draft_sewing(Workroom& workroom, const std::string& garment, const std::filesystem::path& file);

/// What `toile drape` and `toile render` are asked for; empty names leave the choice to the script's first drape
/// command, or to there being only one.
struct DrapeRequest {
  std::string garment;
  std::string body;
  std::vector<std::filesystem::path> files;  // by their endings
  std::filesystem::path report;              // empty: none
};
void drape_once(Workroom& workroom, const DrapeRequest& request);

/// What `toile develop` is asked for; without a garment the script's first develop command is meant.
struct DevelopRequest {
  std::string garment;
  std::vector<std::filesystem::path> files;
  std::filesystem::path report;  // empty: none
};
void develop_once(Workroom& workroom, const DevelopRequest& request);

struct RenderRequest {
  DrapeRequest drape;
  std::filesystem::path file;
  std::string view;   // empty: the default
  std::string field;  // empty: the cloth's own colours
  int width = 800, height = 800;
};
void render_once(Workroom& workroom, const RenderRequest& request);

}  // namespace toile
