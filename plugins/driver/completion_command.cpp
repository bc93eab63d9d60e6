// talweg completion: scripts by which bash, zsh and fish complete the commands and their options.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"

namespace talweg::driver {
namespace {

struct Word {
  std::string name;  ///< a command, or an option with its dashes
  std::string text;
  bool takes_value = false;
};

struct CommandWords {
  Word command;
  std::vector<Word> options;
};

/// The first clause of a text, in single quotes that all three shells understand.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text.substr(0, text.find_first_of(".;:(\n"))) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

void add_options(const CLI::App& app, std::vector<Word>& words) {
  for (const CLI::Option* option : app.get_options()) {
    const bool takes_value = option->get_items_expected_max() > 0;
    const auto add = [&](const std::string& name) {
      words.push_back({name, option->get_description(), takes_value});
    };
    for (const std::string& name : option->get_snames()) add("-" + name);
    for (const std::string& name : option->get_lnames()) add("--" + name);
  }
}

/// The commands of the help. Each command has its own options and those of the app.
std::vector<CommandWords> commands_of(const CLI::App& app) {
  std::vector<CommandWords> all;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_group().empty()) continue;  // hidden
    CommandWords words{{sub->get_name(), sub->get_description()}, {}};
    add_options(*sub, words.options);
    const CLI::Option* help = app.get_help_ptr();
    std::vector<Word> common;
    add_options(app, common);
    for (const Word& word : common) {
      if (help == nullptr || !help->check_name(word.name)) words.options.push_back(word);
    }
    all.push_back(std::move(words));
  }
  return all;
}

std::string names_of(const std::vector<Word>& words) {
  std::string names;
  for (const Word& word : words) names += (names.empty() ? "" : " ") + word.name;
  return names;
}

std::string for_bash(const std::vector<CommandWords>& commands, const std::vector<Word>& common) {
  std::string names, cases;
  for (const auto& [command, options] : commands) {
    names += (names.empty() ? "" : " ") + command.name;
    cases += fmt::format("      {}) options=\"{}\"; break ;;\n", command.name, names_of(options));
  }
  return fmt::format(
      "# Completion of talweg for bash, by talweg completion bash.\n"
      "_talweg() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} commands=\"{}\" options=\"{}\" k\n"
      "  for ((k = 1; k < COMP_CWORD; ++k)); do\n"
      "    case ${{COMP_WORDS[k]}} in\n{}    esac\n"
      "  done\n"
      "  COMPREPLY=()\n"
      "  if [[ $word == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")\n"
      "  elif ((k == COMP_CWORD && COMP_CWORD == 1)); then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$commands\" -- \"$word\")\n"
      "  fi  # else files\n"
      "}}\n"
      "complete -o default -F _talweg talweg\n",
      names, names_of(common), cases);
}

std::string described(const std::vector<Word>& words) {
  std::string result;
  for (const Word& word : words) {
    const std::string text = quoted(word.text);
    result += fmt::format(" '{}:{}", word.name, text.substr(1));
  }
  return result;
}

std::string for_zsh(const std::vector<CommandWords>& commands, const std::vector<Word>& common) {
  std::vector<Word> names;
  std::string cases;
  for (const auto& [command, options] : commands) {
    names.push_back(command);
    cases += fmt::format("    {}) options=({} ) ;;\n", command.name, described(options));
  }
  return fmt::format(
      "#compdef talweg\n"
      "# Completion of talweg for zsh, by talweg completion zsh.\n"
      "_talweg() {{\n"
      "  local -a commands options\n"
      "  commands=({} )\n"
      "  options=({} )\n"
      "  case ${{words[2]}} in\n{}  esac\n"
      "  if [[ $PREFIX == -* ]]; then\n"
      "    _describe -o option options\n"
      "  elif ((CURRENT == 2)); then\n"
      "    _describe command commands\n"
      "  else\n"
      "    _files\n"
      "  fi\n"
      "}}\n"
      "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n"
      "  _talweg \"$@\"\n"
      "else\n"
      "  compdef _talweg talweg\n"
      "fi\n",
      described(names), described(common), cases);
}

std::string for_fish(const std::vector<CommandWords>& commands) {
  std::string result = "# Completion of talweg for fish, by talweg completion fish.\n";
  for (const auto& [command, options] : commands) {
    result += fmt::format("complete -c talweg -n __fish_use_subcommand -f -a {} -d {}\n",
                          command.name, quoted(command.text));
    for (const Word& option : options) {
      const bool is_long = option.name.starts_with("--");
      result +=
          fmt::format("complete -c talweg -n '__fish_seen_subcommand_from {}' -{} {}{} -d {}\n",
                      command.name, is_long ? 'l' : 's', option.name.substr(is_long ? 2 : 1),
                      option.takes_value ? " -r" : "", quoted(option.text));
    }
  }
  return result;
}

}  // namespace

Command add_completion(CLI::App& app, const GlobalOptions&) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "Print the completion script for a shell: bash, zsh or fish");
  command->group("");  // packages call the command rather than users
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return [shell, &app] {
    const std::vector<CommandWords> commands = commands_of(app);
    std::vector<Word> common;
    add_options(app, common);
    const std::string script = *shell == "bash"  ? for_bash(commands, common)
                               : *shell == "zsh" ? for_zsh(commands, common)
                                                 : for_fish(commands);
    std::fputs(script.c_str(), stdout);
    return kDone;
  };
}

}  // namespace talweg::driver
