#include <fmt/format.h>

#include <boost/process/child.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <string_view>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "cases/program/replication.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/state/species.h"
#include "io/atomic_file.h"
#include "io/case_protocol.h"
#include "io/frames_pvd.h"
#include "viz/picture.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  std::string source;
  std::optional<std::int64_t> frame;
  std::string out = "packing.png";
  int size = 2000;
  std::string style = "fig1a", colour = "species";
  std::string slice, times = "1x1x1";
  int turning = 0;
  bool compaction = false;
  PictureOptions picture;
};

const std::map<std::string, PictureStyle> styles{{"fig1a", PictureStyle::block},
                                                 {"chains", PictureStyle::chains}};
const std::map<std::string, Colouring> colourings{{"species", Colouring::species},
                                                  {"coordination", Colouring::coordination},
                                                  {"rattlers", Colouring::rattlers},
                                                  {"pressure", Colouring::pressure}};

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const auto& [name, value] : table) names.push_back(name);
  return names;
}

/// z=0.4:0.6 -> the slab between these fractions of the third edge.
Slice parse_slice(const std::string& text) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  if (all.size() > 2 && all[0] >= 'x' && all[0] <= 'z' && all[1] == '=' && colon != std::string_view::npos) {
    const auto from = number_in<double>(all.substr(2, colon - 2));
    const auto upto = number_in<double>(all.substr(colon + 1));
    if (from && upto && 0 <= *from && *from < *upto && *upto <= 1)
      return {.axis = all[0] - 'x', .from = *from, .upto = *upto};
  }
  throw InputError(
      fmt::format("--slice {}: allowed: x, y or z, and two fractions of that edge, like z=0.4:0.6", text));
}

PictureOptions picture_of(const RenderOptions& options, const PackingSource& source) {
  PictureOptions picture = options.picture;
  picture.width = picture.height = options.size;
  picture.style = styles.at(options.style);
  picture.colouring = colourings.at(options.colour);
  // The caption of Fig. 1a explains the colours of two species; colours of many sizes need a scale in the
  // picture.
  if (picture.style == PictureStyle::block && picture.colouring == Colouring::species &&
      !is_polydisperse(source.packing))
    picture.key = false;
  const Times times = parse_times(options.times);
  for (std::size_t k = 0; k < 3; ++k) picture.times[k] = static_cast<int>(times[k]);
  if (picture.style == PictureStyle::chains && copies_of(times) > 1)
    throw InputError("--times " + options.times + ": chains are drawn of one cell; allowed: 1x1x1");
  if (!options.slice.empty()) picture.slice = parse_slice(options.slice);
  if (const auto c = case_about(source, options.source))
    picture.backbone_threshold = backbone_threshold_of(*c);
  return picture;
}

/// The packing. If the picture needs contacts and the file has none, overlaps are taken as contacts.
PackingSource drawn_source(const std::string& name, const RenderOptions& options) {
  PackingSource source = packing_source(name, options.frame);
  const bool asks_for_contacts = options.colour != "species" || options.style == "chains";
  if (source.packing.contacts.empty() && asks_for_contacts)
    source.packing = with_overlaps_as_contacts(source.packing);
  return source;
}

/// packing.png -> packing_0007.png.
fs::path numbered(const fs::path& out, int number) {
  return out.parent_path() / fmt::format("{}_{:04}{}", out.stem().string(), number, out.extension().string());
}

/// Joins the numbered pictures into a film in the same folder if ffmpeg is installed, and prints the result.
void film(const fs::path& out, Console console) {
  namespace bp = boost::process;
  const auto ffmpeg = bp::search_path("ffmpeg");
  if (ffmpeg.empty()) {
    console.out << "no film: ffmpeg is not installed; the numbered pictures are complete\n";
    return;
  }
  const fs::path mp4 = fs::path(out).replace_extension(".mp4");
  const std::string pictures =
      (out.parent_path() / (out.stem().string() + "_%04d" + out.extension().string())).string();
  bp::child run(ffmpeg, "-y", "-loglevel", "error", "-framerate", "24", "-i", pictures, "-vf",
                "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", mp4.string(), bp::std_in < bp::null);
  run.wait();
  if (run.exit_code() != 0) throw OutputError("ffmpeg cannot make " + mp4.string());
  console.out << mp4.string() << '\n';
}

/// Pictures of the packing from all sides, in one full turn.
void render_turning(const RenderOptions& options, const PackingSource& source, Console console) {
  PictureOptions picture = picture_of(options, source);
  picture.room = room_of(source.packing, picture.times);
  for (int n = 0; n < options.turning; ++n) {
    picture.turn = options.picture.turn + 360.0 * n / options.turning;
    const fs::path file = numbered(options.out, n);
    render_picture(source.packing, file, picture);
    console.out << file.string() << std::endl;
  }
  film(options.out, console);
}

/// Pictures of all saved frames of the run, all with the same scale.
void render_compaction(const RenderOptions& options, Console console) {
  const fs::path folder = options.source;
  if (!fs::exists(folder / "frames.pvd"))
    throw InputError(
        options.source +
        ": no frames.pvd in it; a run with output.snapshot_phi or output.snapshot_every above 0 writes one");
  PictureOptions picture;
  int n = 0;
  double drawn = -1;  // time of the last frame drawn
  const auto draw = [&](const PackingSource& source) {
    if (source.packing.time <= drawn) return;
    drawn = source.packing.time;
    if (n == 0) {
      picture = picture_of(options, source);
      picture.room = room_of(source.packing, picture.times);
    }
    const fs::path file = numbered(options.out, n++);
    render_picture(source.packing, file, picture);
    console.out << file.string() << std::endl;
  };
  for (const SavedFrame& frame : read_frames(folder / "frames.pvd"))
    draw(drawn_source((folder / frame.file).string(), options));
  draw(drawn_source(options.source, options));  // the present state of the run
  film(options.out, console);
}

}  // namespace

Command render_command() {
  auto options = std::make_shared<RenderOptions>();
  Command command;
  command.name = "render";
  command.does = "draw a packing, without a display";
  command.example = "furnas render runs/first_packing --out chains.png --style chains";
  command.setup = [options](CommandLine& app) {
    PictureOptions& picture = options->picture;
    picture.key = true;
    add_packing_source(app, options->source, options->frame);
    app.add("--out", options->out, "PNG or JPEG file, by its extension; its folder is made")
        .showing_default();
    app.add("--style", options->style,
            "fig1a: a solid block of spheres (default); chains: contacts as tubes, by their force")
        .one_of(names_of(styles));
    app.add("--colour,--color", options->colour,
            "the quantity that the colour of a sphere shows (default: species)")
        .one_of(names_of(colourings));
    app.add("--size", options->size, "edge of the picture in pixels").between(16, 16384).showing_default();
    app.add("--times", options->times, "repeat the cell along its edges, e.g. 10x10x10").showing_default();
    app.add("--slice", options->slice, "only the spheres with their centres in a slab, e.g. z=0.4:0.6");
    app.add("--turn", picture.turn, "turn the point of view about the vertical axis [degrees]")
        .showing_default();
    const Argument turning = app.add("--turning", options->turning,
                                     "number of pictures of one full turn; and a film if ffmpeg is installed")
                                 .between(2, 9999);
    app.flag("--compaction", options->compaction,
             "a numbered picture of each frame of a run (output.snapshot_phi or output.snapshot_every) and "
             "of the end of the run, and a film")
        .excludes(turning);
    app.flag(
        "--no-key", [&picture] { picture.key = false; }, "leave out the legend of the colours");
    app.flag("--transparent", picture.transparent, "no background instead of a white one");
    app.flag(
        "--no-cell", [&picture] { picture.cell = false; }, "leave out the edges of the periodic cell");
  };
  command.run = [options](Console console) {
    require_picture_file(options->out, options->picture.transparent);
    make_folder_of(options->out);
    if (options->compaction) {
      render_compaction(*options, console);
      return ExitCode::done;
    }
    remark_on_older_checkpoint(options->source, console.err);
    const PackingSource source = drawn_source(options->source, *options);
    if (options->turning > 0) {
      render_turning(*options, source, console);
      return ExitCode::done;
    }
    const PictureOptions picture = picture_of(*options, source);
    const std::size_t spheres = source.packing.size() * copies_of(parse_times(options->times));
    console.err << fmt::format("draws {}{} spheres, {} x {} pixels\n", picture.slice ? "a slice of " : "",
                               spheres, picture.width, picture.height)
                << std::flush;
    render_picture(source.packing, options->out, picture);
    console.out << options->out << '\n' << key_of(source.packing, picture) << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
