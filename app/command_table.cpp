// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and options of the program, as data.
#include "app/command_line.h"

namespace hydroscope {
namespace {

const std::vector<std::string> kViews = {"contact-map",    "tool-normals",     "slip", "thickness",
                                         "plastic-strain", "contact-pressure", "gap",  "detachment",
                                         "chatter",        "release-margin"};

const Option kSet{"--set", "", "KEY=VALUE", "Replace a key of the scene, e.g. --set tool.die.friction=0.1.",
                  true,    {}};

std::vector<Option> frame_options() {
  return {
      {"--views", "", "A,B",
       "Sequences to draw, of: contact-map, tool-normals, slip, thickness,\n"
       "                            plastic-strain, contact-pressure, gap, detachment, chatter,\n"
       "                            release-margin.",
       false, kViews},
      {"--frames", "", "N", "Number of frames over the process time.", false, {}},
      {"--size", "", "WxH", "Pixels of a frame, e.g. 1920x1080.", false, {}},
      {"--camera", "", "HOW", "fixed, orbit, or look-at:NODE.", false, {"fixed", "orbit", "look-at:"}},
      {"--theme", "", "NAME", "light or dark.", false, {"light", "dark"}},
      {"--animation",
       "",
       "KIND",
       "Film beside the frames: none, webp or mp4.",
       false,
       {"none", "webp", "mp4"}},
  };
}

CommandSyntax make_run() {
  CommandSyntax run;
  run.name = "run";
  run.operands = {"SCENE"};
  run.operand_files = "toml";
  run.summary = "Solve a scene; write results and frames.";
  run.options = {
      {"--output", "-o", "DIR", "Folder for the results (default: results/NAME of the scene).", false, {}},
      {"--force", "", "", "Replace the results of an earlier run in DIR.", false, {}},
      kSet,
      {"--threads", "", "N", "Threads of the solver; the result does not depend on it.", false, {}},
      {"--no-frames", "", "", "Draw nothing while solving (hydroscope render can do it later).", false, {}},
      {"--replay",
       "",
       "JOURNAL",
       "Repeat the acts of a steered run, headless; SCENE may be left out.",
       false,
       {}},
  };
  run.instead_of_operands = "--replay";
  for (const Option& option : frame_options()) run.options.push_back(option);
  run.details =
      "DIR is made only after the scene and all its files have been accepted. It gets history.csv (a row an\n"
      "increment), events.csv (contact events), states.pvd (for ParaView), frames/VIEW/00001.png ..., and at "
      "the\n"
      "very end summary.json: without it the run has not finished, but what is there is whole.\n"
      "Ctrl-C ends the run after the increment under way and keeps all results; a second Ctrl-C ends it at "
      "once.\n"
      "\nexample:\n  hydroscope run scenes/job-b.toml -o results/mu01 --set tool.die.friction=0.1 --views "
      "thickness\n"
      "\nWith --replay the journal.jsonl of a run that was steered is repeated; the same states come out, "
      "bit for "
      "bit\n(default folder: results/NAME-replay). See docs/steering.md.\n"
      "\nAll scene keys: hydroscope reference, or docs/scene_reference.md.\n";
  return run;
}

CommandSyntax make_console() {
  CommandSyntax console;
  console.name = "console";
  console.operands = {"SCENE"};
  console.operand_files = "toml";
  console.summary = "Steer an analysis from the terminal or a script.";
  console.options = {
      {"--output", "-o", "DIR", "Folder for the results (default: results/NAME of the scene).", false, {}},
      {"--force", "", "", "Replace the results of an earlier run in DIR.", false, {}},
      kSet,
      {"--threads", "", "N", "Threads of the solver; the result does not depend on it.", false, {}},
  };
  console.details =
      "Commands come from standard input, one a line; 'help' lists them. From a script the next line is read "
      "when\nthe analysis has halted, and the first error ends the program with exit code 2. In a terminal "
      "Ctrl-C pauses;\nonce more, it ends the run. All acts go to DIR/journal.jsonl, branches to "
      "DIR/branches/1 ...\n"
      "\nexample:\n  printf 'until touch\\nset tool.die.friction 0.2\\nrun\\n' | hydroscope console "
      "scenes/job-b.toml\n"
      "\nCommands, journal, branches, replay: docs/steering.md\n";
  return console;
}

CommandSyntax make_render() {
  CommandSyntax render;
  render.name = "render";
  render.operands = {"DIR"};
  render.operand_files = "/";
  render.summary = "Draw the saved states of a run again, without solving.";
  render.options = frame_options();
  render.options.push_back({"--follow",
                            "",
                            "WHAT",
                            "detachment: a close-up of each patch that let go, with charts.",
                            false,
                            {"detachment"}});
  render.options.push_back(
      {"--patch", "", "N,M", "With --follow: these patches of hydroscope inspect.", false, {}});
  render.options.push_back({"--node", "", "N,M", "With --follow: these nodes in the charts.", false, {}});
  render.options.push_back(kSet);
  render.details =
      "Frames go to DIR/frames/VIEW and replace those of the same view. Settings that are not given are "
      "those\n"
      "of the run. There are as many frames as saved states ([states] number in the scene).\n"
      "With --follow, DIR/frames/detachment-PATCH/ shows states before, at and after the letting go "
      "(--frames: how\n"
      "many before and after, 3), coloured as the first of --views says (detachment), beside charts of the "
      "most\n"
      "pulled node; --set frames.zoom=4 comes closer to it.\n"
      "\nexample:\n  hydroscope render results/mu01 --views plastic-strain,gap --size 1920x1080 --theme "
      "dark\n";
  return render;
}

CommandSyntax make_check() {
  CommandSyntax check;
  check.name = "check";
  check.operands = {"DIR"};
  check.operand_files = "/";
  check.summary = "Compare saved states with an approved sequence.";
  check.options = {
      {"--baseline", "", "BASE", "Folder of the approved sequence.", false, {}},
      {"--update", "", "", "Approve: make BASE anew from DIR, and say what changes.", false, {}},
      {"--report",
       "",
       "OUT",
       "Folder for junit.xml, index.html and pictures (default: DIR/check).",
       false,
       {}},
      {"--threads", "", "N", "Threads of the renderer; pictures do not depend on it.", false, {}},
      {"--pictures", "", "N", "With --update: pictures kept of each view (default 6).", false, {}},
      {"--views", "", "A,B", "With --update: sequences to compare.", false, kViews},
      {"--size", "", "WxH", "With --update: pixels of a picture (default 480x270).", false, {}},
      {"--camera",
       "",
       "HOW",
       "With --update: fixed, orbit, or look-at:NODE.",
       false,
       {"fixed", "orbit", "look-at:"}},
      {"--theme", "", "NAME", "With --update: light or dark.", false, {"light", "dark"}},
      kSet,
  };
  check.details =
      "DIR is the folder of a run, or its folder of states. All is drawn anew from the saved states; "
      "compared "
      "are\nthe sequence, the numbers of each frame, the forces of each state, contact classes as drawn and "
      "as "
      "solved,\nand pictures. Exit code 0: as approved; 1: different, see OUT/index.html; 5: nothing can be "
      "drawn "
      "here.\n"
      "\nexamples:\n  hydroscope check results/mu01 --baseline approved/mu01 --update\n"
      "  hydroscope check results/mu01 --baseline approved/mu01\n"
      "\nLimits, and use in a continuous integration: docs/rendering_checks.md\n";
  return check;
}

CommandSyntax make_inspect() {
  CommandSyntax inspect;
  inspect.name = "inspect";
  inspect.operands = {"DIR"};
  inspect.operand_files = "/";
  inspect.summary = "List what let go of a tool, when and why.";
  inspect.options = {
      {"--node", "", "N", "The whole life of one node instead of the ledger.", false, {}},
      {"--tool", "", "NAME", "Only this tool.", false, {}},
      {"--node-range", "", "A-B", "Only nodes A to B.", false, {}},
      {"--region", "", "BOX", "Only events in X0,X1,Y0,Y1,Z0,Z1 [mm].", false, {}},
      {"--from", "", "S", "Only events from this process time [s].", false, {}},
      {"--to", "", "S", "Only events up to this process time [s].", false, {}},
      {"--kind",
       "",
       "A,B",
       "Touches with an event of these kinds: touch, stick, slip,\n"
       "                            detach (default), retouch.",
       false,
       {"touch", "stick", "slip", "detach", "retouch"}},
      {"--verdict",
       "",
       "A,B",
       "Only these: physical, noise, chatter.",
       false,
       {"physical", "noise", "chatter"}},
      {"--sort",
       "",
       "BY",
       "time (default), node, force, gap, toggles, verdict.",
       false,
       {"time", "node", "force", "gap", "toggles", "verdict"}},
      {"--limit", "", "N", "Lines of a table (default 20; 0: all).", false, {}},
      {"--json", "", "", "For programs: summary, patches, all episodes.", false, {}},
      {"--csv", "", "", "For spreadsheets: an episode a line.", false, {}},
  };
  inspect.details =
      "Reads events.csv, history.csv and the saved states of a run, finished or not, and solves nothing. An "
      "episode\nis one touch of a node, from touching to letting go; neighbours that let go together are a "
      "patch. Each\nletting go is judged: physical (the wall opened), noise (it did not) or chatter (to and "
      "fro).\n"
      "\nexamples:\n  hydroscope inspect results/mu01\n"
      "  hydroscope inspect results/mu01 --verdict noise,chatter --sort toggles\n"
      "  hydroscope inspect results/mu01 --node 17\n"
      "\nEvery column, and how a verdict is found: docs/inspection.md\n";
  return inspect;
}

CommandSyntax make_serve() {
  CommandSyntax serve;
  serve.name = "serve";
  serve.operands = {"SCENE|DIR"};
  serve.summary = "Steer a scene, or look at results, in a browser.";
  serve.options = {
      {"--port", "", "N", "Port to listen at (default 0: any free one).", false, {}},
      {"--host", "", "ADDRESS", "Address to listen at (default 127.0.0.1: this machine only).", false, {}},
      {"--open", "", "", "Open the page in the browser of this machine.", false, {}},
      {"--run", "", "", "Start at once; without it the run stands paused at the start.", false, {}},
      {"--output", "-o", "DIR", "Folder for the results (default: results/NAME of the scene).", false, {}},
      {"--force", "", "", "Replace the results of an earlier run in DIR.", false, {}},
      kSet,
      {"--threads", "", "N", "Threads of the solver; the result does not depend on it.", false, {}},
  };
  serve.details =
      "Prints one line with an address that holds a secret token, made anew at each start: open it in a\n"
      "browser. Several viewers may look on; one of them steers. Closing the browser does not end the run;\n"
      "Ctrl-C does, after the increment under way, and keeps all results. From another machine:\n"
      "ssh -L 8080:127.0.0.1:8080 HOST, with --port 8080.\n"
      "\nexamples:\n  hydroscope serve scenes/square-bulge.toml -o results/try --open\n"
      "  hydroscope serve results/square-bulge\n"
      "\nThe addresses that programs may use: docs/workstation_api.md\n";
  return serve;
}

CommandSyntax make_chart() {
  CommandSyntax chart;
  chart.name = "chart";
  chart.operands = {"STUDY"};
  chart.operand_files = "toml";
  chart.summary = "Run a study: settings side by side, on charts.";
  chart.options = {
      {"--output",
       "-o",
       "DIR",
       "Folder for runs, charts and report (default: results/NAME of the study).",
       false,
       {}},
      {"--only", "", "A,B", "Only these cases.", false, {}},
      {"--list", "", "", "Only list the runs.", false, {}},
      {"--jobs", "", "N", "Accuracy runs at a time (default: as many as cores).", false, {}},
      {"--repeats", "", "N", "Timed repeats of each run.", false, {}},
      {"--no-timing", "", "", "No timed runs, and no charts of wall time.", false, {}},
      {"--draw-only",
       "",
       "",
       "Run nothing: charts and report from the runs that are there, whatever made them.",
       false,
       {}},
      {"--size", "", "WxH", "Pixels of a chart (default 1600x1000).", false, {}},
      {"--theme", "", "NAME", "light or dark.", false, {"light", "dark"}},
  };
  chart.details =
      "Each run is a process of this program in DIR/runs. What has been run with the same program, scene "
      "and\n"
      "settings is not run again: after Ctrl-C the same command goes on. A run that fails is a point on the\n"
      "charts, with its cause. DIR gets report.md, a PNG and a CSV for each chart, and tables of all "
      "values.\n"
      "\nexamples:\n  hydroscope chart scenes/studies/methods.toml -o results/methods\n"
      "  hydroscope chart scenes/studies/methods.toml -o results/methods --only mesh,capstan\n"
      "\nAll keys of a study: docs/charts.md\n";
  return chart;
}

CommandSyntax make_tool() {
  CommandSyntax tool;
  tool.name = "tool";
  tool.operands = {"FILE"};
  tool.summary = "Check a tool mesh (STL, OBJ, PLY) and draw a picture of it.";
  tool.options = {
      {"--unit-scale", "", "S", "Length of the file's unit in mm (1000 for metres; default 1).", false, {}},
      {"--output", "-o", "PNG", "Picture (default: none).", false, {}},
      {"--crease-angle", "", "DEG", "Edges sharper than this are counted (default 40).", false, {}},
      {"--size", "", "WxH", "Pixels of the picture.", false, {}},
      {"--theme", "", "NAME", "light or dark.", false, {"light", "dark"}},
  };
  tool.details = "example:\n  hydroscope tool die.stl -o die.png\n";
  return tool;
}

}  // namespace

const std::vector<CommandSyntax>& command_syntaxes() {
  static const std::vector<CommandSyntax> commands = {
      make_run(),
      make_console(),
      make_render(),
      make_check(),
      make_inspect(),
      make_serve(),
      make_chart(),
      make_tool(),
      {"reference", {}, "", "Print the documentation of all scene keys (Markdown).", "", {}, {}},
      {"completion",
       {"SHELL"},
       "",
       "Print a completion script for bash or zsh.",
       "examples:\n  eval \"$(hydroscope completion bash)\"\n  hydroscope completion zsh > "
       "~/.zfunc/_hydroscope\n",
       {},
       {"bash", "zsh"}},
  };
  return commands;
}

}  // namespace hydroscope
