#include "app/panels/inspector/group_section.h"

#include "app/panels/inspector/inspected.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"
#include "app/widgets/look/group_tags.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/quantity.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

QString nameOf(GroupRole role)
{
    switch (role) {
    case GroupRole::Clipped:
        return GroupSection::tr("Clip to below");
    case GroupRole::Mask:
        return GroupSection::tr("Mask");
    case GroupRole::Wash:
        return GroupSection::tr("Wash");
    case GroupRole::Draft:
        return GroupSection::tr("Draft");
    }
    return {};
}

QString tipOf(GroupRole role)
{
    switch (role) {
    case GroupRole::Clipped:
        return GroupSection::tr("The group is seen only where the next thing below it in the same group is: for "
                                "shading a shape without leaving it.");
    case GroupRole::Mask:
        return GroupSection::tr("The group is not seen itself; what else is in the same group is seen only where it "
                                "has paint.");
    case GroupRole::Wash:
        return GroupSection::tr("All strokes of the group are one, laid wet into wet: their densities add up, with "
                                "one style and one mixing. Filled strokes, hidden ones and those of a mask within it "
                                "stay by themselves.");
    case GroupRole::Draft:
        return GroupSection::tr("The group is seen here, and left out of pictures and films that are exported: for "
                                "sketches and pictures to paint over.");
    }
    return {};
}

/// Why none of the groups can have a role.
QString refusalOf(GroupRole role)
{
    switch (role) {
    case GroupRole::Clipped:
        return GroupSection::tr("There is nothing below it to clip to.");
    case GroupRole::Mask:
        return GroupSection::tr("There is nothing beside it to mask.");
    case GroupRole::Wash:
        return GroupSection::tr("It is in a wash already.");
    case GroupRole::Draft:
        break;
    }
    return {};
}

/// A check of several: half where they differ.
void check(QCheckBox &box, std::ptrdiff_t on, std::ptrdiff_t all)
{
    const bool some = on > 0 && on < all;
    box.setTristate(some);
    box.setCheckState(some ? Qt::PartiallyChecked : on > 0 ? Qt::Checked : Qt::Unchecked);
}

} // namespace

GroupSection::GroupSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_title = sectionTitle(tr("Group"), this);
    column->addWidget(m_title);
    QGridLayout *grid = addFieldGrid(*column);
    addOpacity(*grid);
    addMode(*grid);
    addIsolated(*grid);
    addRole(*grid, GroupRole::Clipped);
    addRole(*grid, GroupRole::Mask);
    addRole(*grid, GroupRole::Draft);
    addTag(*grid);
    addRole(*grid, GroupRole::Wash);
    m_wash = new WashRows(editor, *grid, this);
    connect(m_wash, &WashRows::refused, this, [this](const QString &hint) {
        emit refused(hint);
        refresh();
    });
    showMode({});
    showIsolated({});
}

void GroupSection::addOpacity(QGridLayout &grid)
{
    m_opacity = new SliderField(
        shareSpec(tr("Opacity"),
                  tr("How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap "
                     "in it do not show through each other."),
                  1),
        grid, 0, this);
    connect(m_opacity, &SliderField::refused, this, &GroupSection::refused);
    connect(m_opacity, &SliderField::edited, this, [this](double value, ValueEntry *entry) {
        const Document &document = m_editor.document();
        m_editor.push(setGroupOpacity(document, selectedGroups(document), float(value)), tr("Change group opacity"),
                      entry);
    });
    connect(m_opacity, &SliderField::editedRelative, this, [this](const ValueMap &map) {
        const Document &document = m_editor.document();
        bool possible = true;
        Edit edit =
            changeBlending(document, *document.painting(), selectedGroups(document), [&](Group &now, const Group &) {
                const std::optional<double> mapped = map(double(now.opacity));
                possible = possible && mapped;
                now.opacity = float(mapped.value_or(double(now.opacity)));
            });
        if (possible)
            m_editor.push(std::move(edit), tr("Change group opacity"));
        else
            emit refused(tr("Not possible for all that is selected: a value would be out of range."));
    });
    connect(m_opacity, &SliderField::changed, this, [this](const ValueChange &change, ValueEntry *entry) {
        const Document &document = m_editor.document();
        const PaintingPtr start = entry->start(document);
        m_editor.push(changeBlending(document, *start, selectedGroups(document),
                                     [&](Group &now, const Group &then) {
                                         now.opacity = float(change.applied(double(then.opacity)));
                                     }),
                      tr("Change group opacity"), entry);
    });
}

void GroupSection::addMode(QGridLayout &grid)
{
    m_mode = ComboRow::add(grid, 1, tr("Mode"), {}, {}, this);
    addBlendModes(*m_mode.box);
    m_mode.box->setMaxVisibleItems(m_mode.box->count());
    connect(m_mode.box, &QComboBox::activated, this, [this](int index) {
        const Document &document = m_editor.document();
        m_editor.push(setGroupBlend(document, selectedGroups(document), modeAt(*m_mode.box, index)),
                      tr("Change group mode"));
    });
}

void GroupSection::addIsolated(QGridLayout &grid)
{
    m_isolated = new QCheckBox(tr("Mix by itself"), this);
    grid.addWidget(m_isolated, 2, 1, 1, 2);
    connect(m_isolated, &QCheckBox::clicked, this, &GroupSection::isolate);
}

void GroupSection::addRole(QGridLayout &grid, GroupRole role)
{
    auto *box = m_roles[std::size_t(role)] = new QCheckBox(nameOf(role), this);
    box->setToolTip(tipOf(role));
    grid.addWidget(box, grid.rowCount(), 1, 1, 2);
    connect(box, &QCheckBox::clicked, this, [this, role] {
        commands::toggleSelectedRole(m_editor, role);
        refresh();
    });
}

void GroupSection::addTag(QGridLayout &grid)
{
    m_tag =
        ComboRow::add(grid, grid.rowCount(), tr("Tag"),
                      tr("A colour that marks the group for you, in lists. It is not seen in the picture."), {}, this);
    for (int tag = 0; tag < groupTags; ++tag)
        m_tag.box->addItem(iconOf(GroupTag(tag)), nameOf(GroupTag(tag)));
    m_tag.box->setMaxVisibleItems(groupTags);
    connect(m_tag.box, &QComboBox::activated, this, [this](int index) {
        const Document &document = m_editor.document();
        m_editor.push(setGroupTag(document, selectedGroups(document), GroupTag(index)), tr("Mark group"));
    });
}

/// Groups that are isolated by how they are put there keep what they had: their switch is not seen to change.
void GroupSection::isolate(bool on)
{
    const Document &document = m_editor.document();
    m_editor.push(changeBlending(document, *document.painting(), selectedGroups(document),
                                 [on](Group &now, const Group &) {
                                     if (!now.blends())
                                         now.isolated = on;
                                 }),
                  on ? tr("Mix group by itself") : tr("Mix group with what lies below"));
    refresh();
}

void GroupSection::refresh()
{
    const Document &document = m_editor.document();
    const std::vector<GroupId> ids = selectedGroups(document);
    std::vector<const Group *> groups;
    for (const GroupId id : ids)
        if (const Group *group = document.painting()->findGroup(id))
            groups.push_back(group);
    setVisible(!groups.empty());
    if (groups.empty())
        return;
    m_title->setText(groups.size() == 1 ? tr("Group") : tr("Groups"));
    keepChange(groups);
    m_opacity->setValue(commonNumber(groups, [](const Group *group) { return group->opacity; }));
    showMode(groups);
    showIsolated(groups);
    const GroupRoles roles(*document.painting());
    for (const GroupRole role : groupRoles)
        showRole(role, roles.of(ids, role));
    const auto tag = commonValue(groups, [](const Group *group) { return group->tag; });
    m_tag.box->setCurrentIndex(tag ? int(*tag) : -1);
    m_wash->refresh(groups);
}

/// A change that is shown is forgotten when the opacities are not what it made of them any more.
void GroupSection::keepChange(const std::vector<const Group *> &groups)
{
    m_opacity->keepChange([&, start = m_opacity->entry().start()](const ValueChange &change) {
        return std::ranges::all_of(groups, [&](const Group *group) {
            const Group *then = start ? start->findGroup(group->id) : nullptr;
            return then && group->opacity == float(change.applied(double(then->opacity)));
        });
    });
}

void GroupSection::showMode(const std::vector<const Group *> &groups)
{
    const auto mode = commonValue(groups, [](const Group *group) { return group->blend; });
    if (mode)
        chooseMode(*m_mode.box, *mode);
    else
        m_mode.box->setCurrentIndex(-1);
    const QString tip = tr("How the group's picture is put on what lies below. Any mode but Normal has its strokes mix "
                           "by themselves first.");
    //: the mode that is chosen, and what it does
    m_mode.box->setToolTip(mode ? tip + QLatin1Char('\n') + tr("%1: %2").arg(nameOf(*mode), tipOf(*mode)) : tip);
}

void GroupSection::showIsolated(const std::vector<const Group *> &groups)
{
    const auto isolated = std::ranges::count_if(groups, &Group::isIsolated);
    const bool isFree = !std::ranges::all_of(groups, &Group::blends);
    check(*m_isolated, isolated, std::ssize(groups));
    m_isolated->setEnabled(isFree);
    m_isolated->setToolTip(
        isFree ? tr("The group's strokes mix among themselves, and their picture is put on what lies below. Otherwise "
                    "they mix with what lies below as if there were no group.")
               : tr("The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a "
                    "mask."));
}

void GroupSection::showRole(GroupRole role, const GroupRoles::State &state)
{
    QCheckBox &box = *m_roles[std::size_t(role)];
    const bool isPossible = !state.possible.empty();
    check(box, state.having, std::ssize(state.possible));
    box.setEnabled(isPossible);
    box.setToolTip(isPossible ? tipOf(role) : tipOf(role) + QLatin1Char('\n') + refusalOf(role));
}

} // namespace suffuse
