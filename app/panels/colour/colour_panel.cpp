#include "app/panels/colour/colour_panel.h"

#include "app/panels/colour/colour_wheel.h"
#include "app/panels/colour/swatch_grid.h"
#include "app/panels/colour/swatches_section.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/colour/mixing_pad.h"
#include "app/widgets/look/section.h"
#include "undo/edits.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>

#include <algorithm>

namespace suffuse {

namespace {

/// The colour as "#rrggbb", without the opacity.
QString hexOf(const Colour &colour)
{
    return toOpaqueScreen(colour).name();
}

std::optional<Colour> storedColour(const QString &name)
{
    if (const auto colour = colourOfText(name))
        return colour;
    const QColor screen(name); // Earlier versions kept colours like this.
    return screen.isValid() ? std::optional(fromScreen(screen)) : std::nullopt;
}

std::vector<Colour> storedColours(std::size_t most)
{
    std::vector<Colour> colours;
    for (const QString &name : settings::store().value("recentColours").toStringList().mid(0, qsizetype(most)))
        if (const auto colour = storedColour(name))
            colours.push_back(*colour);
    return colours;
}

} // namespace

ColourPanel::ColourPanel(Editor &editor, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_recent(storedColours(recentCount)), m_used(editor.brush().colour)
{
    auto *outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    auto *scroll = new PanelScroll(this);
    outer->addWidget(scroll);
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);

    auto *top = new QHBoxLayout; // What is used most often stands on top, where low windows show it, too.
    top->setSpacing(8);
    m_wheel = new ColourWheel(content);
    m_swatches = new SwatchesSection(editor, content);
    top->addWidget(m_wheel, 3);
    top->addWidget(m_swatches, 2);
    column->addLayout(top);
    addCurrent(*column);
    m_rows = new ColourRows(true, content);
    column->addWidget(m_rows);
    m_hint = new HintLabel(content);
    column->addWidget(m_hint);
    addRecent(*column);
    m_mixing = new MixingSection(editor, content);
    column->addWidget(m_mixing, 1);
    scroll->setWidget(content);
    addApply(*outer); // The button stands below what scrolls, so it is seen however low the dock is.

    connect(m_wheel, &ColourWheel::picked, &editor, &Editor::setColour);
    connect(m_rows, &ColourRows::edited, this, [this](int channel, double value) {
        Colour colour = m_editor.brush().colour;
        ColourRows::channelOf(colour, channel) = float(value);
        m_editor.setColour(colour);
    });
    connect(m_rows, &ColourRows::refused, m_hint, &HintLabel::showRefusal);
    connect(&editor, &Editor::brushChanged, this, &ColourPanel::refresh);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (change.selection || change.reset)
            m_apply->setEnabled(!m_editor.document().selection().isEmpty());
        if (change.draft && m_editor.document().draft())
            rememberUsed();
    });
    m_apply->setEnabled(!editor.document().selection().isEmpty());
    showRecent();
    refresh();
}

QSize ColourPanel::sizeHint() const
{
    return {280, 420};
}

void ColourPanel::addCurrent(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_current = new ColourSwatch(this);
    m_current->setSide(28);
    m_current->setAccessibleName(tr("Current colour"));
    m_current->setToolTip(tr("The colour that is painted with"));
    m_current->setFocusPolicy(Qt::NoFocus);
    m_previous = new ColourSwatch(this);
    m_previous->setSide(28);
    m_previous->setAccessibleName(tr("Previous colour"));
    m_previous->setToolTip(tr("The colour painted with last. Click: back to it."));
    auto *label = new QLabel(tr("Hex"), this);
    m_hex = new QLineEdit(this);
    m_hex->setMaxLength(9);
    m_hex->setAccessibleName(tr("Hex"));
    m_hex->setToolTip(tr("sRGB colour as #rrggbb, or #rgb"));
    m_hex->setFixedWidth(m_hex->fontMetrics().horizontalAdvance("#ddddddd") + 18);
    label->setBuddy(m_hex);
    row->addWidget(m_current);
    row->addWidget(m_previous);
    row->addStretch(1);
    row->addWidget(label);
    row->addSpacing(4);
    row->addWidget(m_hex);
    column.addLayout(row);
    connect(m_previous, &ColourSwatch::clicked, this, [this] { m_editor.setColour(m_used); });
    connect(m_hex, &QLineEdit::editingFinished, this, &ColourPanel::takeHex);
}

void ColourPanel::addRecent(QVBoxLayout &column)
{
    m_history = new SwatchGrid(false, this);
    m_history->setAccessibleName(tr("Recent colours"));
    m_history->setToolTip(tr("Colours painted with before. Click: take it."));
    m_history->setEmptyText(tr("Colours painted with come here."));
    column.addWidget(m_history);
    connect(m_history, &SwatchGrid::picked, &m_editor, &Editor::setColour);
}

void ColourPanel::addApply(QVBoxLayout &column)
{
    m_apply = new QPushButton(tr("Apply to selection"), this);
    m_apply->setToolTip(tr("Gives the selected segments this colour. They keep their opacity."));
    auto *row = new QHBoxLayout;
    row->setContentsMargins(8, 4, 8, 8);
    row->addWidget(m_apply);
    column.addLayout(row);
    connect(m_apply, &QPushButton::clicked, this, &ColourPanel::applyToSelection);
}

void ColourPanel::refresh()
{
    const Colour &colour = m_editor.brush().colour;
    m_hint->showHint({}); // An earlier message about a refused colour no longer applies.
    m_wheel->setColour(colour);
    m_rows->setColour(colour);
    m_current->setColour(colour);
    m_previous->setColour(m_used);
    if (!m_hex->hasFocus() || !m_hex->isModified())
        m_hex->setText(hexOf(colour));
}

void ColourPanel::takeHex()
{
    if (!m_hex->isModified())
        return;
    static const QRegularExpression form("^#?([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})$");
    const QRegularExpressionMatch match = form.match(m_hex->text().trimmed());
    m_hex->setModified(false);
    if (match.hasMatch()) {
        m_hint->showHint({});
        Colour colour = fromScreen(QColor("#" + match.captured(1)));
        colour.opacity = m_editor.brush().colour.opacity;
        m_editor.setColour(colour);
    } else {
        m_hint->showRefusal(tr("“%1” is not a colour. Write it as #rrggbb, for example #2f6690.").arg(m_hex->text()));
    }
    m_hex->setText(hexOf(m_editor.brush().colour));
}

void ColourPanel::applyToSelection()
{
    Document &document = m_editor.document();
    const Colour colour = m_editor.brush().colour;
    const auto apply = [&](Segment &s) { s.colour = {colour.red, colour.yellow, colour.blue, s.colour.opacity}; };
    m_editor.push(changeSegments(document, targetSegments(document), apply), tr("Apply colour"));
}

void ColourPanel::rememberUsed()
{
    const Colour colour = m_editor.brush().colour;
    if (colour == m_used && !m_recent.empty())
        return;
    m_used = colour;
    m_previous->setColour(m_used);
    // Two colours that look the same stand here once.
    std::erase_if(m_recent, [&](const Colour &c) { return toScreen(c) == toScreen(colour); });
    m_recent.insert(m_recent.begin(), colour);
    m_recent.resize(std::min(m_recent.size(), recentCount));
    // What was used in other windows stays in the list.
    settings::updateList("recentColours", [&colour](QStringList names) {
        names.removeIf([&colour](const QString &name) {
            const auto other = storedColour(name);
            return !other || toScreen(*other) == toScreen(colour);
        });
        names.prepend(textOf(colour));
        return names.mid(0, qsizetype(recentCount));
    });
    showRecent();
}

void ColourPanel::showRecent()
{
    std::vector<Swatch> recent;
    for (const Colour &colour : m_recent)
        recent.push_back({{}, colour});
    m_history->setSwatches(std::move(recent));
}

} // namespace suffuse
