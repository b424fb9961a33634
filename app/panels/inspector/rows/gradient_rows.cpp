#include "app/panels/inspector/rows/gradient_rows.h"

#include "app/session/editor.h"
#include "app/widgets/colour/colour_rows.h"
#include "model/painting/editable.h"
#include "undo/fill_edits.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

GradientRows::GradientRows(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto *row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Gradient"), this));
    row->addStretch();
    const auto button = [this, row](const QString &text, const QString &tip, auto edit, const QString &step) {
        auto *made = new QToolButton(this);
        made->setText(text);
        made->setToolTip(tip);
        row->addWidget(made);
        connect(made, &QToolButton::clicked, this, [this, edit, step] {
            m_editor.push(edit(m_editor.document(), m_editor.document().selection().strokes), step);
        });
        return made;
    };
    m_add = button(tr("Add"), tr("The fill's colour fades from left to right. The Segments tool drags the ends."),
                   &addGradients, tr("Add gradient"));
    m_swap = button(tr("Swap"), tr("The two colours change places"), &swapGradients, tr("Swap colours of gradient"));
    m_remove =
        button(tr("Remove"), tr("The fill has its first colour everywhere"), &removeGradients, tr("Remove gradient"));
    column->addLayout(row);
    m_colour = new ColourRows(true, this);
    m_colour->setToolTip(tr("The second colour of the gradient"));
    column->addWidget(m_colour);
    connect(m_colour, &ColourRows::edited, this, &GradientRows::set);
    connect(m_colour, &ColourRows::editedRelative, this, &GradientRows::changeEach);
    connect(m_colour, &ColourRows::changed, this, &GradientRows::changeTogether);
    connect(m_colour, &ColourRows::refused, this, &GradientRows::refused);
}

void GradientRows::set(int channel, double value, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    m_editor.push(changeFills(document, *document.painting(), document.selection().strokes,
                              [=](Fill &now, const Fill &) {
                                  if (now.gradient)
                                      ColourRows::channelOf(now.gradient->colour, channel) = float(value);
                              }),
                  tr("Change gradient"), entry);
}

void GradientRows::changeEach(int channel, const ValueMap &map)
{
    const Document &document = m_editor.document();
    bool possible = true;
    Edit edit = changeFills(document, *document.painting(), document.selection().strokes, [&](Fill &now, const Fill &) {
        if (!now.gradient)
            return;
        float &value = ColourRows::channelOf(now.gradient->colour, channel);
        const std::optional<double> mapped = map(double(value));
        possible = possible && mapped;
        value = float(mapped.value_or(double(value)));
    });
    if (possible)
        m_editor.push(std::move(edit), tr("Change gradient"));
    else
        emit refused(tr("Not possible for all that is selected: a value would be out of range."));
}

void GradientRows::changeTogether(int channel, const ValueChange &change, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    const PaintingPtr start = entry->start(document);
    m_editor.push(changeFills(document, *start, document.selection().strokes,
                              [&](Fill &now, const Fill &then) {
                                  if (!now.gradient || !then.gradient)
                                      return;
                                  const float before = ColourRows::channelOf(then.gradient->colour, channel);
                                  ColourRows::channelOf(now.gradient->colour, channel) =
                                      float(change.applied(double(before)));
                              }),
                  tr("Change gradient"), entry);
}

void GradientRows::refresh(const Inspected &inspected)
{
    std::vector<const Colour *> colours;
    bool isFlat = false;
    for (const Stroke *stroke : inspected.strokes) {
        if (!stroke->fill)
            continue;
        if (stroke->fill->gradient)
            colours.push_back(&stroke->fill->gradient->colour);
        else
            isFlat = true;
    }
    m_add->setVisible(isFlat);
    m_swap->setVisible(!colours.empty());
    m_remove->setVisible(!colours.empty());
    m_colour->setVisible(!colours.empty());
    if (colours.empty())
        return;
    std::array<std::optional<double>, 4> channels;
    const Locks isLocked(inspected.painting->groups);
    for (int channel = 0; channel < 4; ++channel) {
        const auto valueOf = [channel](const Fill &fill) {
            return double(ColourRows::channelOf(fill.gradient->colour, channel));
        };
        SliderField &row = *m_colour->row(channel);
        row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
            return std::ranges::all_of(inspected.strokes, [&](const Stroke *stroke) {
                const StrokePtr then = start ? start->find(stroke->id) : nullptr;
                if (!stroke->fill || !stroke->fill->gradient || !then || !then->fill || !then->fill->gradient)
                    return start && !(stroke->fill && stroke->fill->gradient);
                return isLocked(*stroke) ||
                       float(valueOf(*stroke->fill)) == float(change.applied(valueOf(*then->fill)));
            });
        });
        channels[std::size_t(channel)] =
            commonNumber(colours, [channel](const Colour *colour) { return ColourRows::channelOf(*colour, channel); });
    }
    m_colour->setColour(channels, *colours.front());
}

} // namespace suffuse
