#include "app/panels/inspector/group_section.h"

#include "app/panels/inspector/inspected.h"
#include "app/session/editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/quantity.h"
#include "undo/group_edits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

const Group *groupWithId(const Painting &painting, GroupId id)
{
    const auto at = std::ranges::find(painting.groups, id, &Group::id);
    return at == painting.groups.end() ? nullptr : &*at;
}

/// Whether its opacity or its mode isolates the group, whatever its switch says.
bool mustBeIsolated(const Group &group)
{
    Group without = group;
    without.isolated = false;
    return without.isIsolated();
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
    auto *label = new QLabel(tr("Mode"), this);
    m_mode = new QComboBox(this);
    addBlendModes(*m_mode);
    m_mode->setPlaceholderText(QStringLiteral("—"));
    m_mode->setAccessibleName(tr("Mode"));
    m_mode->setMaxVisibleItems(m_mode->count());
    m_mode->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_mode->setMinimumContentsLength(8);
    label->setBuddy(m_mode);
    grid.addWidget(label, 1, 0);
    grid.addWidget(m_mode, 1, 1, 1, 2);
    connect(m_mode, &QComboBox::activated, this, [this](int index) {
        const Document &document = m_editor.document();
        m_editor.push(setGroupBlend(document, selectedGroups(document), modeAt(*m_mode, index)),
                      tr("Change group mode"));
    });
}

void GroupSection::addIsolated(QGridLayout &grid)
{
    m_isolated = new QCheckBox(tr("Mix by itself"), this);
    grid.addWidget(m_isolated, 2, 1, 1, 2);
    connect(m_isolated, &QCheckBox::clicked, this, &GroupSection::isolate);
}

/// Groups that are isolated by their opacity or mode keep what they had: their switch is not seen to change.
void GroupSection::isolate(bool on)
{
    const Document &document = m_editor.document();
    m_editor.push(changeBlending(document, *document.painting(), selectedGroups(document),
                                 [on](Group &now, const Group &) {
                                     if (!mustBeIsolated(now))
                                         now.isolated = on;
                                 }),
                  on ? tr("Mix group by itself") : tr("Mix group with what lies below"));
    refresh();
}

void GroupSection::refresh()
{
    const Document &document = m_editor.document();
    std::vector<const Group *> groups;
    for (const GroupId id : selectedGroups(document))
        if (const Group *group = groupWithId(*document.painting(), id))
            groups.push_back(group);
    setVisible(!groups.empty());
    if (groups.empty())
        return;
    m_title->setText(groups.size() == 1 ? tr("Group") : tr("Groups"));
    keepChange(groups);
    m_opacity->setValue(commonNumber(groups, [](const Group *group) { return group->opacity; }));
    showMode(groups);
    showIsolated(groups);
}

/// A change that is shown is forgotten when the opacities are not what it made of them any more.
void GroupSection::keepChange(const std::vector<const Group *> &groups)
{
    m_opacity->keepChange([&, start = m_opacity->entry().start()](const ValueChange &change) {
        return std::ranges::all_of(groups, [&](const Group *group) {
            const Group *then = start ? groupWithId(*start, group->id) : nullptr;
            return then && group->opacity == float(change.applied(double(then->opacity)));
        });
    });
}

void GroupSection::showMode(const std::vector<const Group *> &groups)
{
    const auto mode = commonValue(groups, [](const Group *group) { return group->blend; });
    if (mode)
        chooseMode(*m_mode, *mode);
    else
        m_mode->setCurrentIndex(-1);
    const QString tip = tr("How the group's picture is put on what lies below. Any mode but Normal has its strokes mix "
                           "by themselves first.");
    //: the mode that is chosen, and what it does
    m_mode->setToolTip(mode ? tip + QLatin1Char('\n') + tr("%1: %2").arg(nameOf(*mode), tipOf(*mode)) : tip);
}

void GroupSection::showIsolated(const std::vector<const Group *> &groups)
{
    const auto isolated = std::ranges::count_if(groups, &Group::isIsolated);
    const bool some = isolated > 0 && isolated < std::ssize(groups);
    const bool isFree = !std::ranges::all_of(groups, [](const Group *group) { return mustBeIsolated(*group); });
    m_isolated->setTristate(some);
    m_isolated->setCheckState(some ? Qt::PartiallyChecked : isolated > 0 ? Qt::Checked : Qt::Unchecked);
    m_isolated->setEnabled(isFree);
    m_isolated->setToolTip(
        isFree ? tr("The group's strokes mix among themselves, and their picture is put on what lies below. Otherwise "
                    "they mix with what lies below as if there were no group.")
               : tr("Its opacity or its mode has the group mix by itself in any case."));
}

} // namespace suffuse
