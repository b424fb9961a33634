#include "app/panels/inspector/rows/wash_rows.h"

#include "app/panels/inspector/inspected.h"
#include "app/panels/inspector/stroke_section.h"
#include "app/session/editor.h"
#include "app/widgets/numbers/quantity.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"
#include "undo/layers/group_edits.h"

#include <QComboBox>
#include <QGridLayout>

#include <algorithm>

namespace suffuse {

namespace {

auto xiOf(std::size_t index)
{
    return [index](Wash &wash) { return int(index) < xiCount(wash.style.kind) ? &wash.style.xi[index] : nullptr; };
}

float *betaOf(Wash &wash)
{
    return wash.mix.mode == MixMode::Beta ? &wash.mix.beta : nullptr;
}

} // namespace

WashRows::WashRows(Editor &editor, QGridLayout &grid, QWidget *parent) : QObject(parent), m_editor(editor)
{
    const int row = grid.rowCount();
    m_kind = ComboRow::add(grid, row, tr("Kind"), tr("How the density of all strokes of the wash becomes coverage."),
                           styleNames(), parent);
    m_xi = XiFields(grid, row + 1, parent);
    m_mode = ComboRow::add(grid, row + 4, tr("Mixing"),
                           tr("How the wash mixes with what lies below it: it covers, or pigments add up."),
                           mixingNames(), parent);
    m_beta = new SliderField(specOf(Quantity::Beta), grid, row + 5, parent);
    for (std::size_t i = 0; i < 3; ++i)
        addNumber(*m_xi[i], xiOf(i));
    addNumber(*m_beta, betaOf);
    connect(m_kind.box, &QComboBox::activated, this, [this](int index) {
        change(*m_editor.document().painting(), [style = XiFields::defaultStyle(StyleKind(index))](Wash &now, auto &) {
            if (now.style.kind != style.kind)
                now.style = style;
        });
    });
    connect(m_mode.box, &QComboBox::activated, this, [this](int index) {
        change(*m_editor.document().painting(), [mix = StrokeSection::usualMix(MixMode(index))](Wash &now, auto &) {
            if (now.mix.mode != mix.mode)
                now.mix = mix;
        });
    });
}

void WashRows::addNumber(SliderField &field, const Member &member)
{
    connect(&field, &SliderField::refused, this, &WashRows::refused);
    connect(&field, &SliderField::edited, this, [this, member](double value, ValueEntry *entry) {
        const auto set = [&](Wash &now, const Wash &) {
            if (float *number = member(now))
                *number = float(value);
        };
        change(*m_editor.document().painting(), set, entry);
    });
    connect(&field, &SliderField::editedRelative, this, [this, member](const ValueMap &map) {
        change(*m_editor.document().painting(), [&](Wash &now, const Wash &) {
            // A value beyond the range makes the wash invalid, and the whole change is refused.
            if (float *number = member(now))
                *number = float(map(double(*number)).value_or(-1));
        });
    });
    connect(&field, &SliderField::changed, this, [this, member](const ValueChange &change, ValueEntry *entry) {
        const PaintingPtr start = entry->start(m_editor.document());
        const auto apply = [&](Wash &now, Wash then) {
            float *number = member(now);
            if (const float *before = member(then); number && before)
                *number = float(change.applied(double(*before)));
        };
        this->change(*start, apply, entry);
    });
}

void WashRows::change(const Painting &before, const Change &change, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    QString problem;
    Edit edit = changeBlending(document, before, selectedGroups(document), [&](Group &now, const Group &then) {
        if (!now.wash)
            return;
        change(*now.wash, then.wash.value_or(*now.wash));
        for (const QString &wrong : {problemOf(now.wash->style), problemOf(now.wash->mix)})
            if (problem.isEmpty())
                problem = wrong;
    });
    if (problem.isEmpty())
        m_editor.push(std::move(edit), tr("Change wash"), entry);
    else
        emit refused(tr("Not possible for all that is selected: %1").arg(problem));
}

/// A change that is shown is forgotten when the numbers are not what it made of them any more.
void WashRows::keepChange(SliderField &field, const std::vector<const Group *> &groups, const Member &member)
{
    field.keepChange([&, start = field.entry().start()](const ValueChange &change) {
        return std::ranges::all_of(groups, [&](const Group *group) {
            Wash now = *group->wash;
            const Group *before = start ? start->findGroup(group->id) : nullptr;
            if (!before || !before->wash)
                return false;
            Wash then = *before->wash;
            const float *number = member(now), *number0 = member(then);
            return number ? number0 && *number == float(change.applied(double(*number0))) : !number0;
        });
    });
}

void WashRows::refresh(const std::vector<const Group *> &groups)
{
    std::vector<const Group *> washes, pigments;
    std::ranges::copy_if(groups, std::back_inserter(washes), [](const Group *g) { return g->wash.has_value(); });
    std::ranges::copy_if(washes, std::back_inserter(pigments),
                         [](const Group *g) { return g->wash->mix.mode == MixMode::Beta; });
    std::vector<Style> styles;
    for (const Group *group : washes)
        styles.push_back(group->wash->style);
    m_kind.setVisible(!washes.empty());
    m_mode.setVisible(!washes.empty());
    m_beta->setVisible(!washes.empty());
    m_xi.show(styles);
    if (washes.empty())
        return;
    const auto kind = commonValue(washes, [](const Group *group) { return group->wash->style.kind; });
    m_kind.box->setCurrentIndex(kind ? int(*kind) : -1);
    for (std::size_t i = 0; kind && i < 3; ++i)
        keepChange(*m_xi[i], washes, xiOf(i));
    m_xi.setValues(styles);
    const auto mode = commonValue(washes, [](const Group *group) { return group->wash->mix.mode; });
    m_mode.box->setCurrentIndex(mode ? int(*mode) : -1);
    m_beta->setEnabled(!pigments.empty());
    keepChange(*m_beta, pigments, betaOf);
    m_beta->setValue(commonNumber(pigments, [](const Group *group) { return group->wash->mix.beta; }));
}

} // namespace suffuse
