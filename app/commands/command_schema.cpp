#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/schema/schema.h"

namespace knuckle {

void addSchemaCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand(
        "schema", "Print the JSON Schema (draft 7) of scene, actor, joint, limit, golden or sweep files");
    command->fallthrough();
    command->footer("Examples:\n"
                    "  knuckle schema > scene.schema.json   for editors that complete and check as you type\n"
                    "  knuckle schema actor                 what `knuckle voxelize -o` writes\n"
                    "  knuckle schema joints                what `knuckle voxelize --joints` reads\n"
                    "  knuckle schema limits                what `knuckle compare --limits` reads\n"
                    "  knuckle schema golden                a golden.json of `knuckle golden`\n"
                    "  knuckle schema sweep                 a plan of `knuckle sweep`");
    auto document = std::make_shared<std::string>("scene");
    auto markdown = std::make_shared<bool>(false);
    command
        ->add_option("DOCUMENT", *document,
                     "Which: scene, actor (actor files), joints (joint overrides), limits (of compare), golden, sweep")
        ->check(CLI::IsMember({"scene", "actor", "joints", "limits", "golden", "sweep"}))
        ->capture_default_str();
    command->add_flag("--markdown", *markdown, "As a page of tables, as docs/scene.md");
    command->callback([=] {
        line.chosen = [=] {
            const Schema schema(*document + ".schema.json");
            fmt::print("{}", *markdown ? schemaMarkdown(schema) : std::string(schema.text()));
            return EXIT_FINE;
        };
    });
}

}  // namespace knuckle
