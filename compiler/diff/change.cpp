// Header: compiler/diff/change.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/change.hpp"

#include <algorithm>
#include <array>

namespace director::compiler {

namespace {

using Kind = ChangeKind;

constexpr std::array pages{
    ChangeKindPage{Kind::refused, "refused",
                   "The new behaviour has errors in its text or its names: nothing of it is compared."},
    ChangeKindPage{Kind::hardened, "hardened", "A transition that was soft is hard now: one task cuts off the other."},
    ChangeKindPage{Kind::takeover_gained, "takeover_gained",
                   "A task can take a group from another one, always or sometimes, where it could not."},
    ChangeKindPage{Kind::takeover_lost, "takeover_lost",
                   "A task can no longer, or no longer always, take a group from another one."},
    ChangeKindPage{Kind::tie_order, "tie_order",
                   "Of two tasks of equal rank that are requested at once, the other one goes first now."},
    ChangeKindPage{Kind::unit, "unit",
                   "What is granted all or none has changed: a task became optional, mandatory or apart."},
    ChangeKindPage{Kind::became_dead, "became_dead", "Something that could run or be requested never can now."},
    ChangeKindPage{Kind::became_reachable, "became_reachable",
                   "Something that could never run or be requested now may be."},
    ChangeKindPage{Kind::condition_loosened, "condition_loosened",
                   "A provider may run, or stay, under more values of a state."},
    ChangeKindPage{Kind::condition_tightened, "condition_tightened",
                   "A provider may run, or stay, under fewer values of a state."},
    ChangeKindPage{Kind::push_gained, "push_gained", "A task that waits may push a provider that it could not push."},
    ChangeKindPage{Kind::push_lost, "push_lost", "A task that waits can no longer push a provider."},
    ChangeKindPage{Kind::bound_grew, "bound_grew", "Something may take longer, comes less often, or may try more."},
    ChangeKindPage{Kind::preference, "preference",
                   "The order in which providers are tried, or pushed for what a task waits for, has changed."},
    ChangeKindPage{Kind::promise, "promise", "A provider promises other values of a state in `causing`."},
    ChangeKindPage{Kind::sets, "sets", "A provider may set other values of a state."},
    ChangeKindPage{Kind::handler, "handler", "A start or stop handler is new, is gone, or sets other values."},
    ChangeKindPage{Kind::needs_added, "needs_added", "A provider needs one more group."},
    ChangeKindPage{Kind::needs_removed, "needs_removed", "A provider needs one group less."},
    ChangeKindPage{Kind::request_added, "request_added",
                   "The program or a provider may request one more task, or in one more pack."},
    ChangeKindPage{Kind::request_removed, "request_removed",
                   "The program or a provider requests one task less, or in one pack less."},
    ChangeKindPage{Kind::state_values, "state_values",
                   "The values of a state have changed, or their order, or which of them are `unordered`."},
    ChangeKindPage{Kind::state_initial, "state_initial", "A state begins with another value."},
    ChangeKindPage{Kind::state_source, "state_source",
                   "What may set a state has changed, or what happens to it if nothing sets it."},
    ChangeKindPage{Kind::triggers, "triggers", "What calls a provider again has changed, or a trigger is new or gone."},
    ChangeKindPage{
        Kind::levels, "levels",
        "The named levels of a request have changed, which of them counts without a name, or what *keep* keeps."},
    ChangeKindPage{Kind::transition_changed, "transition_changed",
                   "Control passes from one task to another in another way than before, when it is played."},
    ChangeKindPage{Kind::softened, "softened", "A transition that was hard is soft now."},
    ChangeKindPage{Kind::bound_shrank, "bound_shrank",
                   "Something is promised sooner, comes more often, or may try less."},
    ChangeKindPage{Kind::group_removed, "group_removed", "A group is gone."},
    ChangeKindPage{Kind::provider_removed, "provider_removed", "A provider of a group that remains is gone."},
    ChangeKindPage{Kind::state_removed, "state_removed", "A state is gone."},
    ChangeKindPage{Kind::assertion, "assertion", "What the author relies on has changed."},
    ChangeKindPage{Kind::api, "api", "Names or types in the generated C++ have changed."},
    ChangeKindPage{Kind::realtime, "realtime", "Whether the bodies of a group must not block has changed."},
    ChangeKindPage{Kind::uses, "uses", "What a body sees of other groups has changed."},
    ChangeKindPage{Kind::group_added, "group_added", "A group is new."},
    ChangeKindPage{Kind::provider_added, "provider_added", "A provider of a group that existed is new."},
    ChangeKindPage{Kind::state_added, "state_added", "A state is new."},
    ChangeKindPage{Kind::accepted, "accepted",
                   "The old behaviour had errors in its text or its names, the new one has none."},
    ChangeKindPage{Kind::finding_new, "finding_new", "A check finds something that it did not find before."},
    ChangeKindPage{Kind::finding_gone, "finding_gone", "A check finds something no longer."},
    ChangeKindPage{Kind::priority, "priority",
                   "A priority is another number, and nothing was found that a task takes otherwise."},
    ChangeKindPage{Kind::layers, "layers", "Layers have changed, which only pictures and pages show."},
};

static_assert(std::all_of(pages.begin(), pages.end(), [](const ChangeKindPage& page) {
  return page.kind == static_cast<Kind>(&page - pages.data());
}));

} // namespace

std::span<const ChangeKindPage> change_kinds() { return pages; }

const ChangeKindPage& page_of(ChangeKind kind) { return pages[static_cast<std::size_t>(kind)]; }

} // namespace director::compiler
