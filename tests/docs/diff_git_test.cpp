// SPDX-License-Identifier: MIT
// `directorc diff` with git: revisions, its difftool, and the hook that docs/diff.md offers.
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <fstream>

namespace {

using namespace director::tests;
namespace fs = std::filesystem;

/// Git words its error otherwise where the folder is on a file system of its own.
const std::string environment =
    "export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 GIT_DISCOVERY_ACROSS_FILESYSTEM=1; ";

Ran run_outside(const std::string& command) {
  const TemporaryFolder outside;
  return run_command(environment + "export LC_ALL=C; " + command, outside.path());
}

/// A repository with a behaviour in a folder, which imports another one, and two commits.
class Repository {
public:
  Repository() {
    run("git init --quiet . && git config user.name Nobody && git config user.email nobody@example.org");
    write("robot/walker.yaml", walker("[Legs]"));
    write("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}, Arms: {}}\n");
    write("other.yaml", "roots: of something else\n");
    CHECK(run("git add . && git commit --quiet -m first").status == 0);
  }
  static std::string walker(const std::string& needs) {
    return "behaviour: walker\nlanguage: 1\nimports: [parts/legs.yaml]\nroots: [Walk]\ngroups: {Walk: {needs: " +
           needs + "}}\n";
  }
  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((folder_.path() / path).parent_path());
    std::ofstream(folder_.path() / path) << text;
  }
  Ran run(const std::string& command) const {
    // Git words its error otherwise where the folder is on a file system of its own.
    return run_command("export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 GIT_DISCOVERY_ACROSS_FILESYSTEM=1; " +
                           command,
                       folder_.path());
  }

private:
  TemporaryFolder folder_;
};

const char* const needs_arms = "needs_added: A provider needs one more group.\n"
                               "  `Walk` now needs `Arms`\n"
                               "    now    robot/walker.yaml:5:31\n"
                               "    before HEAD:robot/walker.yaml:5:10\n"
                               "\n"
                               "1 change\n";

const char* const no_repository = "directorc: `walker.yaml` is in no git repository that can be read (git: not a git "
                                  "repository (or any of the parent "
                                  "directories): .git)\n";

} // namespace

TEST_CASE("a file is compared with itself in a revision, from wherever it is called") {
  const Repository repository;
  CHECK(repository.run("directorc diff --git HEAD robot/walker.yaml").output.empty());
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  const Ran ran = repository.run("directorc diff --git HEAD robot/walker.yaml");
  CHECK(ran.output == needs_arms);
  CHECK(ran.status == 0);
  CHECK(repository.run("cd robot/parts && directorc diff --git HEAD ../walker.yaml --breaking=needs_added").status ==
        1);
}

TEST_CASE("a place in a revision is one that git takes") {
  const Repository repository;
  // At the top, in a folder, and imported from a folder above; in a branch whose name has a slash.
  std::string top = Repository::walker("[Legs]");
  repository.write("top.yaml", top.insert(top.find("parts"), "robot/"));
  repository.write("robot/up.yaml", "behaviour: up\nlanguage: 1\nimports: [../arms.yaml]\nroots: [Arms]\n");
  repository.write("arms.yaml", "behaviour: arms\nlanguage: 1\ngroups: {Arms: {}}\n");
  REQUIRE(repository.run("git add . && git commit --quiet -m second && git branch my/work").status == 0);
  repository.write("arms.yaml", "behaviour: arms\nlanguage: 1\ngroups: {Arms: {stop: true}}\n");
  const auto places = [&](const std::string& file) {
    return repository
        .run("cd robot && directorc diff --git my/work " + file +
             " | sed -n 's/^    before \\(.*\\):[0-9]*:[0-9]*$/\\1/p' | sort -u")
        .output;
  };
  CHECK(places("up.yaml") == "my/work:arms.yaml\n");
  CHECK(repository.run("cd robot && git show my/work:arms.yaml").output.starts_with("behaviour: arms\n"));
  repository.write("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {stop: true}, Arms: {}}\n");
  CHECK(places("../top.yaml") == "my/work:robot/parts/legs.yaml\n");
}

TEST_CASE("a file that is renamed is compared with its old content") {
  const Repository repository;
  REQUIRE(
      repository.run("mkdir legged && git mv robot/walker.yaml legged/strider.yaml && git mv robot/parts legged/parts")
          .status == 0);
  const auto moved = [&] {
    std::string out = needs_arms;
    return out.replace(out.find("robot/walker"), 12, "legged/strider");
  };
  CHECK(repository.run("directorc diff --git HEAD legged/strider.yaml").output.empty());
  CHECK(repository.run("directorc diff --staged legged/strider.yaml").output.empty());
  repository.write("legged/strider.yaml", Repository::walker("[Legs, Arms]"));
  CHECK(repository.run("directorc diff --git HEAD legged/strider.yaml").output == moved());
  CHECK(repository.run("directorc diff --staged legged/strider.yaml").output.empty());
  CHECK(repository.run("git add . && directorc diff --staged legged/strider.yaml").output == moved());
  CHECK(repository.run("mv legged away && directorc diff --staged legged/strider.yaml; mv away legged").output ==
        moved());
  // The hook too.
  REQUIRE(
      repository.run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() + "' .git/hooks/pre-commit").status ==
      0);
  const Ran hook = repository.run("cd legged && git commit --quiet -m moved");
  CHECK(hook.output == "legged/strider.yaml:\n" + moved() + "\n");
  CHECK(hook.status == 0);
  CHECK(repository.run("directorc diff --git HEAD~1 legged/strider.yaml").output ==
        moved().replace(moved().find("HEAD"), 4, "HEAD~1"));
}

TEST_CASE("what the old one imported is read in that revision too") {
  const Repository repository;
  repository.write("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {stop: true}, Arms: {}}\n");
  CHECK(repository.run("directorc diff --git HEAD robot/walker.yaml").output.starts_with("handler: "));
  CHECK(
      repository.run("git commit --quiet -a -m second && directorc diff --git HEAD robot/walker.yaml").output.empty());
  CHECK(repository.run("directorc diff --git HEAD~1 robot/walker.yaml").output.starts_with("handler: "));
}

TEST_CASE("an unknown revision or file is reported, with status 2") {
  const Repository repository;
  const Ran revision = repository.run("directorc diff --git v1 robot/walker.yaml");
  CHECK(revision.output == "directorc: git knows no revision `v1`\n");
  CHECK(revision.status == 2);
  const Ran option = repository.run("directorc diff --git=--help robot/walker.yaml");
  CHECK(option.output == "directorc: git knows no revision `--help`\n");
  repository.write("new.yaml", Repository::walker("[]"));
  const Ran file = repository.run("directorc diff --git HEAD new.yaml");
  CHECK(file.output ==
        "directorc: cannot read `HEAD:new.yaml`: no such file in the revision `HEAD`\n"
        "  help: where it was called otherwise, `git add new.yaml` lets git see that; any two files are compared "
        "with `directorc diff OLD NEW`\n");
  CHECK(file.status == 2);
  const Ran none = run_outside("directorc diff --git HEAD walker.yaml");
  CHECK(none.output == no_repository);
}

TEST_CASE("git's own error is a part of the message, and nothing is beside it") {
  const Repository repository;
  for (const char* other : {"HEAD^{tree}", "HEAD:robot/walker.yaml"}) {
    const Ran ran = repository.run("directorc diff --git '" + std::string(other) + "' robot/walker.yaml");
    CHECK(ran.output == "directorc: `" + std::string(other) + "` is no commit: name one, a branch or a tag\n");
    CHECK(ran.status == 2);
  }
  const Ran upstream =
      repository.run("git checkout --quiet -b mine && LC_ALL=C directorc diff --git '@{u}' robot/walker.yaml");
  CHECK(upstream.output == "directorc: git knows no revision `@{u}` (git: no upstream configured for branch 'mine')\n");
  const Ran broken = repository.run("echo nonsense >.git/HEAD; LC_ALL=C directorc diff --git HEAD robot/walker.yaml");
  CHECK(broken.output == "directorc: `robot/walker.yaml` is in no git repository that can be read (git: not a git "
                         "repository (or any of the parent directories): .git)\n");
}

TEST_CASE("it is a tool of git difftool, and imports are those beside the new file") {
  const Repository repository;
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  const Ran ran = repository.run("git difftool --no-prompt -x 'directorc diff' HEAD -- robot/walker.yaml");
  CHECK(ran.output.find("  `Walk` now needs `Arms`\n") != std::string::npos);
}

TEST_CASE("of a file that is new or gone git's difftool has nothing to compare") {
  const Repository repository;
  repository.write("new.yaml", Repository::walker("[]"));
  REQUIRE(repository.run("git add new.yaml && git rm --quiet robot/walker.yaml").status == 0);
  const auto tool = [&](const std::string& file) {
    return repository.run("git difftool --no-prompt -x 'directorc diff' HEAD -- " + file).output;
  };
  CHECK(tool("new.yaml") == "`new.yaml` is new: there is nothing to compare\n");
  CHECK(tool("robot/walker.yaml").ends_with("walker.yaml` is gone: there is nothing to compare\n"));
  const Ran json = repository.run("directorc diff --format=json /dev/null new.yaml");
  CHECK(json.output == "{\n  \"breaking\": false,\n  \"compared\": false,\n  \"changes\": []\n}\n");
  CHECK(json.status == 0);
}

TEST_CASE("the hook reports changes, and refuses the configured ones") {
  const Repository repository;
  const std::string hook = (source_dir() / "docs/hooks/pre-commit").string();
  REQUIRE(repository.run("cp '" + hook + "' .git/hooks/pre-commit").status == 0);
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  const Ran expected_page = repository.run("cd robot && git commit --quiet -a -m second");
  CHECK(expected_page.output == std::string("robot/walker.yaml:\n") + needs_arms + "\n");
  CHECK(expected_page.status == 0);
  repository.write("robot/walker.yaml", Repository::walker("[Legs]"));
  const Ran refused = repository.run("git config director.breaking needs_removed && git commit --quiet -a -m third");
  CHECK(refused.output.find("  breaking: `Walk` no longer needs `Arms`\n") != std::string::npos);
  CHECK(refused.status == 1);
  repository.write("robot/parts/legs.yaml",
                   "behaviour: legs\nlanguage: 1\n# as it was\ngroups: {Arms: {}, Legs: {}}\n");
  repository.write("robot/walker.yaml", Repository::walker("[Arms, Legs]"));
  const Ran silent = repository.run("git commit --quiet -a -m fourth");
  CHECK(silent.output.empty());
  CHECK(silent.status == 0);
}

TEST_CASE("the hook refuses errors that are new, not those that a behaviour had before") {
  const Repository repository;
  const auto half = [](const std::string& rest) {
    return "behaviour: half\nlanguage: 1\nextern: [Arms]\nroots: [Walk]\ngroups: {Walk: {needs: [Arms]}" + rest + "}\n";
  };
  repository.write("half.yaml", half(""));
  REQUIRE(repository.run("git add . && git commit --quiet -m half").status == 0);
  REQUIRE(
      repository.run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() + "' .git/hooks/pre-commit").status ==
      0);
  repository.write("notes.txt", "more\n");
  const Ran other = repository.run("git add . && git commit --quiet -m 'only notes'");
  CHECK(other.output.empty());
  CHECK(other.status == 0);
  repository.write("half.yaml", half(", Legs: {}"));
  const Ran same = repository.run("git commit --quiet -a -m legs");
  CHECK(same.output.starts_with("directorc: neither of the two can be compared: both have errors in their text or "
                                "their names\nHEAD:half.yaml:3:10: error: "));
  CHECK(same.status == 0);
  repository.write("half.yaml", half(", Legs: {needs: [Lags]}"));
  const Ran worse = repository.run("git commit --quiet -a -m lags");
  CHECK(worse.output.find("half.yaml:\n"
                          "refused: The new behaviour has errors in its text or its names: nothing of it is compared.\n"
                          "  there is no group called `Lags`\n"
                          "    now    half.yaml:5:48\n"
                          "\n"
                          "1 change\n\n"
                          "pre-commit: this commit is refused for what is printed above\n") != std::string::npos);
  CHECK(worse.status == 1);
  CHECK(repository.run("git log --format=%s").output == "legs\nonly notes\nhalf\nfirst\n");
}

TEST_CASE("the hook compares a behaviour whose file ends in .yml") {
  const Repository repository;
  repository.write("robot/runner.yml", Repository::walker("[Legs]"));
  REQUIRE(repository.run("git add . && git commit --quiet -m runner").status == 0);
  REQUIRE(
      repository.run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() + "' .git/hooks/pre-commit").status ==
      0);
  repository.write("robot/runner.yml", Repository::walker("[Legs, Arms]"));
  const Ran refused = repository.run("git config director.breaking all && git commit --quiet -a -m second");
  CHECK(refused.output.starts_with("robot/runner.yml:\nneeds_added: A provider needs one more group.\n"));
  CHECK(refused.status == 1);
}

TEST_CASE("what is staged is compared, with what it imports, not the files on the disk") {
  const Repository repository;
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  CHECK(repository.run("directorc diff --staged robot/walker.yaml").output.empty());
  CHECK(repository.run("git add . && directorc diff --staged robot/walker.yaml").output == needs_arms);
  // The file in the folder has been changed since.
  repository.write("robot/walker.yaml", "no behaviour any more");
  CHECK(repository.run("directorc diff --staged robot/walker.yaml").output == needs_arms);
  CHECK(repository
            .run("cd robot/parts && directorc diff --staged --git HEAD \"$PWD/../walker.yaml\" --breaking=needs_added")
            .status == 1);
  // What it imports too: its own change is staged, and then undone in the folder.
  repository.write("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {stop: true}, Arms: {}}\n");
  REQUIRE(repository.run("git add robot/parts && rm robot/parts/legs.yaml").status == 0);
  CHECK(repository.run("directorc diff --staged robot/walker.yaml").output ==
        "handler: A start or stop handler is new, is gone, or sets other values.\n"
        "  `Legs` now has a stop handler (C++ has to follow)\n"
        "    now    robot/parts/legs.yaml:3:23\n"
        "    before HEAD:robot/parts/legs.yaml:3:10\n"
        "\n" +
            std::string(needs_arms).replace(std::string(needs_arms).find("1 change"), 8, "2 changes"));
}

TEST_CASE("a link is followed in a revision and in what is staged, as far as it stays in the repository") {
  const Repository repository;
  REQUIRE(repository
              .run("ln -s walker.yaml robot/link.yaml && ln -s /etc/hosts robot/out.yaml && "
                   "ln -s nowhere.yaml robot/none.yaml && git add . && git commit --quiet -m links")
              .status == 0);
  CHECK(repository.run("directorc diff --git HEAD robot/link.yaml").output.empty());
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  REQUIRE(repository.run("git add .").status == 0);
  repository.write("robot/walker.yaml", "no behaviour any more");
  CHECK(repository.run("directorc diff --staged robot/link.yaml").output ==
        "needs_added: A provider needs one more group.\n"
        "  `Walk` now needs `Arms`\n"
        "    now    robot/link.yaml:5:31\n"
        "    before HEAD:robot/link.yaml:5:10\n"
        "\n"
        "1 change\n");
  const std::string help = "  help: where it was called otherwise, `git add robot/out.yaml` lets git see that; any two "
                           "files are compared with `directorc diff OLD NEW`\n";
  const Ran outside = repository.run("directorc diff --git HEAD robot/out.yaml 2>&1");
  CHECK(outside.status == 2);
  CHECK(outside.output ==
        "directorc: cannot read `HEAD:robot/out.yaml`: it is a link to outside of the repository\n" + help);
  CHECK(
      repository.run("directorc diff --git HEAD robot/none.yaml 2>&1")
          .output.starts_with("directorc: cannot read `HEAD:robot/none.yaml`: no such file in the revision `HEAD`\n"));
}

TEST_CASE("a file that is imported under several names, through links, is one, in a revision and in what is staged") {
  const Repository repository;
  repository.write("bib/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}, Arms: {}}\n");
  repository.write("walk.yaml", "behaviour: walk\nlanguage: 1\nimports: [bib/legs.yaml, lib/legs.yaml]\n"
                                "groups: {Walk: {needs: [Legs]}}\n");
  const std::string head = "behaviour: r\nlanguage: 1\nimports: [walk.yaml, legs.yaml]\nroots: [Walk, Arms]\n";
  repository.write("r.yaml", head);
  REQUIRE(repository
              .run("ln -s bib lib && ln -s mid.yaml legs.yaml && ln -s lib/legs.yaml mid.yaml && "
                   "git add . && git commit --quiet -m links && directorc check r.yaml")
              .status == 0);
  const std::string changed =
      "request_removed: The program or a provider requests one task less, or in one pack less.\n"
      "  the program no longer requests `Arms` (C++ has to follow)\n";
  repository.write("r.yaml", "behaviour: r\nlanguage: 1\nimports: [walk.yaml, legs.yaml]\nroots: [Walk]\n");
  const Ran beside = repository.run("directorc diff --git HEAD r.yaml");
  CHECK(beside.output.find(changed) != std::string::npos);
  // Both sides are read from git: none of the links is on the disk any more.
  const Ran staged = repository.run("git add . && rm -r lib legs.yaml mid.yaml && directorc diff --staged r.yaml");
  CHECK(staged.output == beside.output);
  CHECK(staged.status == 0);
  // And where the imports of a file alone are beside another one.
  repository.run("git checkout --quiet . && mkdir alone");
  repository.write("alone/r.yaml", head);
  CHECK(repository.run("directorc diff alone/r.yaml r.yaml").output.find(changed) != std::string::npos);
}

TEST_CASE("imports that git does not keep are read from the disk on both sides") {
  const Repository repository;
  REQUIRE(repository
              .run("mkdir inner && cd inner && git init --quiet . && git config user.name Nobody && "
                   "git config user.email nobody@example.org && mkdir made deep && echo made >.gitignore")
              .status == 0);
  const auto behaviour = [](const std::string& needs) {
    return "behaviour: walker\nlanguage: 1\nimports: [../../shared.yaml, ../made/arms.yaml]\nroots: [Walk]\n"
           "groups: {Walk: {needs: " +
           needs + "}}\n";
  };
  repository.write("shared.yaml", "behaviour: shared\nlanguage: 1\ngroups: {Legs: {}}\n");
  repository.write("inner/made/arms.yaml", "behaviour: arms\nlanguage: 1\nimports: [../hand.yaml]\n"
                                           "groups: {Arms: {}}\n");
  repository.write("inner/hand.yaml", "behaviour: hand\nlanguage: 1\ngroups: {Hand: {}}\n");
  repository.write("inner/deep/walker.yaml", behaviour("[Legs]"));
  REQUIRE(repository.run("cd inner && git add . && git commit --quiet -m first").status == 0);
  repository.write("inner/deep/walker.yaml", behaviour("[Legs, Arms]"));
  repository.write("inner/hand.yaml", "behaviour: hand\nlanguage: 1\ngroups: {Hand: {stop: true}}\n");
  const std::string expected = "handler: A start or stop handler is new, is gone, or sets other values.\n"
                               "  `Hand` now has a stop handler (C++ has to follow)\n"
                               "    now    ../hand.yaml:3:23\n"
                               "    before HEAD:hand.yaml:3:10\n"
                               "\n"
                               "needs_added: A provider needs one more group.\n"
                               "  `Walk` now needs `Arms`\n"
                               "    now    walker.yaml:5:31\n"
                               "    before HEAD:deep/walker.yaml:5:10\n"
                               "\n"
                               "2 changes\n";
  CHECK(repository.run("cd inner/deep && directorc diff --git HEAD walker.yaml").output == expected);
  CHECK(repository.run("cd inner/deep && git add .. && directorc diff --staged walker.yaml").output == expected);
  CHECK(repository.run("cd inner && directorc diff --git HEAD \"$PWD/deep/walker.yaml\"").status == 0);
  // What only the old one imports is gone.
  repository.write("inner/deep/walker.yaml", "behaviour: walker\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {}}\n");
  const Ran gone = repository.run("rm shared.yaml && directorc diff --git HEAD inner/deep/walker.yaml");
  CHECK(gone.output == "directorc: cannot read `shared.yaml`: No such file or directory; git does not keep it\n");
  CHECK(gone.status == 2);
}

TEST_CASE("imports in a submodule are read in its recorded commit") {
  const Repository repository;
  const std::string behaviour = "behaviour: r\nlanguage: 1\nimports: [lib/parts/legs.yaml]\nroots: [Walk]\n";
  repository.write("r.yaml", behaviour + "groups: {Walk: {}}\n");
  REQUIRE(repository
              .run("git clone --quiet . ../lib$$ && git -c protocol.file.allow=always submodule --quiet add "
                   "\"$(cd .. && pwd)/lib$$\" lib && mkdir lib/parts && mv lib/robot/parts/legs.yaml lib/parts && "
                   "cd lib && git config user.name Nobody && git config user.email nobody@example.org && git add . && "
                   "git commit --quiet -m moved && cd .. && git add . && git commit --quiet -m second; "
                   "status=$?; rm -rf ../lib$$; exit $status")
              .status == 0);
  repository.write("r.yaml", behaviour + "groups: {Walk: {needs: [Legs]}}\n");
  const std::string expected = "needs_added: A provider needs one more group.\n"
                               "  `Walk` now needs `Legs`\n"
                               "    now    r.yaml:5:25\n"
                               "    before HEAD:r.yaml:5:10\n"
                               "\n"
                               "1 change\n";
  CHECK(repository.run("directorc diff --git HEAD r.yaml").output == expected);
  CHECK(repository.run("git add r.yaml && directorc diff --staged r.yaml").output == expected);
  // Without its commit the old behaviour is not known.
  repository.write("r.yaml", "behaviour: r\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {}}\n");
  const Ran lost = repository.run("rm -rf lib && mkdir lib && directorc diff --git HEAD r.yaml 2>&1 | "
                                  "sed 's/commit [0-9a-f]* /commit C /'");
  CHECK(lost.output ==
        "directorc: cannot read `HEAD:lib/parts/legs.yaml`: it is in the submodule `lib`, whose commit C "
        "is not on this computer: `git submodule update --init` fetches it\n");
  CHECK(repository.run("directorc diff --git HEAD r.yaml").status == 2);
}

TEST_CASE("a file that is not staged, or is in no repository, is reported") {
  const Repository repository;
  const Ran gone =
      repository.run("git rm --quiet --cached robot/walker.yaml && directorc diff --staged robot/walker.yaml");
  CHECK(gone.output == "directorc: cannot read `robot/walker.yaml`: no such file is staged\n");
  CHECK(gone.status == 2);
  const Ran two = repository.run("directorc diff --staged robot/walker.yaml robot/walker.yaml");
  CHECK(two.output == "directorc: with --git or --staged there is one file: directorc diff --git REVISION FILE\n");
  const Ran none = run_outside("directorc diff --staged walker.yaml");
  CHECK(none.output == no_repository);
}

TEST_CASE("the hook judges what is committed, not the files on the disk") {
  const Repository repository;
  REQUIRE(repository
              .run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() +
                   "' .git/hooks/pre-commit && "
                   "git config director.breaking needs_added")
              .status == 0);
  const std::string refused = std::string("robot/walker.yaml:\n") +
                              "needs_added: A provider needs one more group.\n"
                              "  breaking: `Walk` now needs `Arms`\n"
                              "    now    robot/walker.yaml:5:31\n"
                              "    before HEAD:robot/walker.yaml:5:10\n"
                              "\n"
                              "1 change, 1 of them breaking\n\n"
                              "pre-commit: this commit is refused for what is printed above\n"
                              "  git config director.breaking says what is breaking: needs_added\n"
                              "  git commit --no-verify commits all the same\n";
  // A change that is not staged is no part of the commit.
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  repository.write("other.yaml", "roots: of something else again\n");
  const Ran beside = repository.run("git add other.yaml && git commit --quiet -m other");
  CHECK(beside.output.empty());
  CHECK(beside.status == 0);
  // One that is staged is, although the file has been corrected since.
  const std::string right = Repository::walker("[Legs]");
  CHECK(repository.run("git add robot/walker.yaml").status == 0);
  repository.write("robot/walker.yaml", right);
  const Ran staged = repository.run("git commit --quiet -m staged");
  CHECK(staged.output == refused);
  CHECK(staged.status == 1);
  CHECK(repository.run("git reset --quiet").status == 0);
  // `git commit FILE` and `git commit -a` have an index of their own, also from within a folder.
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  CHECK(repository.run("git commit --quiet -m one robot/walker.yaml").output == refused);
  CHECK(repository.run("cd robot && git commit --quiet -m one walker.yaml").output == refused);
  CHECK(repository.run("cd robot && git commit --quiet -a -m all").output == refused);
  // A behaviour that the commit removes, and one that is new, have nothing to be compared with.
  repository.write("robot/walker.yaml", right);
  repository.write("new.yaml", "behaviour: new\nlanguage: 1\nroots: [Wait]\ngroups: {Wait: {}}\n");
  const Ran others =
      repository.run("git rm --quiet -f robot/walker.yaml && git add new.yaml && git commit --quiet -m others");
  CHECK(others.output.empty());
  CHECK(others.status == 0);
}

TEST_CASE("the hook reports where the program is expected when it is not found") {
  const Repository repository;
  REQUIRE(
      repository.run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() + "' .git/hooks/pre-commit").status ==
      0);
  repository.write("robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  const Ran ran = repository.run("DIRECTORC=/nowhere/directorc git commit --quiet -a -m second");
  CHECK(ran.output ==
        "pre-commit: there is no program `/nowhere/directorc`: put its folder into PATH, or say where it is,\n"
        "  DIRECTORC=/FOLDER/directorc git commit ...; git commit --no-verify commits without this hook\n");
  CHECK(ran.status == 1); // git's own
  CHECK(repository.run("DIRECTORC=/nowhere/directorc git commit --quiet --no-verify -a -m second").status == 0);
}

TEST_CASE("the hook works in a second working tree") {
  const Repository repository;
  REQUIRE(repository
              .run("cp '" + (source_dir() / "docs/hooks/pre-commit").string() +
                   "' .git/hooks/pre-commit && "
                   "git worktree add --quiet tree -b other")
              .status == 0);
  repository.write("tree/robot/walker.yaml", Repository::walker("[Legs, Arms]"));
  const Ran ran = repository.run("cd tree && git commit --quiet -a -m second");
  CHECK(ran.output == std::string("robot/walker.yaml:\n") + needs_arms + "\n");
}
