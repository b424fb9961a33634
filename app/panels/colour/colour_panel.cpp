#include "app/panels/colour/colour_panel.h"

#include "app/panels/colour/colour_header.h"
#include "app/panels/colour/swatches_section.h"
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/colour/mixing_pad.h"
#include "app/widgets/colour/screen_colour_rows.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/section.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>

namespace suffuse {

namespace {

const QString slidersKey = QStringLiteral("colour/sliders");

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
    outer->setSpacing(0);
    m_header = new ColourHeader(editor, this); // The header stands above what scrolls, so it is always seen.
    outer->addWidget(m_header);
    auto *scroll = new PanelScroll(this);
    outer->addWidget(scroll, 1);
    m_hint = new HintLabel(this); // and so does the hint below it
    outer->addWidget(m_hint);
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
    addSliders(*column);
    addRecent(*column);
    m_mixing = new MixingSection(editor, content);
    column->addWidget(m_mixing, 1);
    scroll->setWidget(content);
    ColourTarget &target = editor.colourTarget();
    connect(m_wheel, &ColourWheel::picked, &target, &ColourTarget::setPaint);
    connect(&target, &ColourTarget::changed, this, &ColourPanel::refresh);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (change.draft && m_editor.document().draft())
            rememberUsed();
    });
    // A drag is about what was selected at the press. It ends when all know what is selected now.
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.selection)
            QMetaObject::invokeMethod(
                this, [this] { endDragsIn(*this); }, Qt::QueuedConnection);
    });
    showRecent();
    refresh();
}

QSize ColourPanel::sizeHint() const
{
    return {280, 420};
}

/// In a low window the wheel makes room for all of the sliders and, where it can, for the recent colours.
void ColourPanel::resizeEvent(QResizeEvent *event)
{
    const QLayout &column = *m_history->parentWidget()->layout();
    const QWidget &sliders = m_rows->isHidden() ? static_cast<QWidget &>(*m_screenRows) : *m_rows;
    const int others = m_header->sizeHint().height() + column.contentsMargins().top() + m_current->sizeHint().height() +
                       sliders.sizeHint().height() + m_history->minimumSizeHint().height() + 4 * column.spacing();
    m_wheel->setMaximumHeight(std::max(m_wheel->minimumSizeHint().height(), height() - others));
    QWidget::resizeEvent(event);
}

void ColourPanel::addCurrent(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_current = new ColourSwatch(this);
    m_current->setSide(28);
    m_current->setAccessibleName(tr("Current colour"));
    m_current->setFocusPolicy(Qt::NoFocus);
    m_previous = new ColourSwatch(this);
    m_previous->setSide(28);
    auto *label = new QLabel(tr("Hex"), this);
    m_hex = new EntryField(this);
    m_hex->setAccessibleName(tr("Hex"));
    m_hex->setToolTip(tr("sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal"));
    m_hex->setFixedWidth(m_hex->fontMetrics().horizontalAdvance("#ddddddd") + 18);
    label->setBuddy(m_hex);
    row->addWidget(m_current);
    row->addWidget(m_previous);
    row->addSpacing(4);
    m_sliders = new QComboBox(this);
    //: red, yellow, blue; hue, saturation, value; red, green, blue
    m_sliders->addItems({tr("RYB"), tr("HSV"), tr("RGB")});
    m_sliders->setAccessibleName(tr("Sliders"));
    m_sliders->setToolTip(tr("The numbers that the sliders show: paint as red, yellow and blue, or the screen's hue, "
                             "saturation and value, or its red, green and blue"));
    row->addWidget(m_sliders);
    row->addStretch(1);
    row->addWidget(label);
    row->addSpacing(4);
    row->addWidget(m_hex);
    column.addLayout(row);
    connect(m_previous, &ColourSwatch::clicked, this, [this] { m_editor.colourTarget().take(beside()); });
    connect(m_hex, &EntryField::typed, this, &ColourPanel::takeHex);
}

void ColourPanel::addSliders(QVBoxLayout &column)
{
    ColourTarget &target = m_editor.colourTarget();
    m_rows = new ColourRows(true, this);
    m_screenRows = new ScreenColourRows(this);
    column.addWidget(m_rows);
    column.addWidget(m_screenRows);
    connect(m_rows, &ColourRows::edited, this, [this, &target](int channel, double value, ValueEntry *entry) {
        if (channel == ColourRows::Opacity)
            return target.setOpacity(float(value), entry);
        constexpr float Colour::*channels[] = {&Colour::red, &Colour::yellow, &Colour::blue};
        target.setChannel(channels[channel], float(value), entry);
    });
    connect(m_rows, &ColourRows::editedRelative, this, [&target](int channel, const ValueMap &map) {
        target.changeEach([channel, &map](Colour each) {
            float &value = ColourRows::channelOf(each, channel);
            value = float(map(value).value_or(value));
            return each;
        });
    });
    connect(m_screenRows, &ScreenColourRows::eachEdited, &target, &ColourTarget::changeEach);
    connect(m_screenRows, &ScreenColourRows::paintEdited, &target, &ColourTarget::setPaint);
    connect(m_screenRows, &ScreenColourRows::opacityEdited, &target,
            [&target](double value, ValueEntry *entry) { target.setOpacity(float(value), entry); });
    connect(m_rows, &ColourRows::refused, this, [this](const QString &why) { m_hint->showRefusal(why); });
    connect(m_screenRows, &ScreenColourRows::refused, this, [this](const QString &why) { m_hint->showRefusal(why); });
    connect(m_sliders, &QComboBox::activated, this, [this](int index) {
        settings::store().setValue(slidersKey, index);
        chooseSliders(index);
    });
    chooseSliders(std::clamp(settings::store().value(slidersKey).toInt(), 0, m_sliders->count() - 1));
}

void ColourPanel::chooseSliders(int index)
{
    m_sliders->setCurrentIndex(index);
    m_rows->setVisible(index == 0);
    m_screenRows->setVisible(index > 0);
    m_screenRows->setModel(index == 1 ? ScreenColourRows::Model::Hsv : ScreenColourRows::Model::Rgb);
}

void ColourPanel::addRecent(QVBoxLayout &column)
{
    m_history = new SwatchGrid(false, this);
    m_history->setAccessibleName(tr("Recent colours"));
    m_history->setToolTip(tr("Colours painted with before. Click: take it."));
    m_history->setEmptyText(tr("Colours painted with come here."));
    column.addWidget(m_history);
    connect(m_history, &SwatchGrid::picked, &m_editor.colourTarget(), [this](const Colour &colour) {
        if (m_editor.colourTarget().kind() == ColourTarget::Kind::Brush)
            m_editor.setColour(colour); // It comes back with the opacity that it was painted with.
        else
            m_editor.colourTarget().setPaint(colour);
    });
}

QAbstractButton *ColourPanel::applyButton() const
{
    return m_header->applyButton();
}

/// The colour beside the shown one, to go back to: of the brush, the one that was painted with last; else the brush's.
Colour ColourPanel::beside() const
{
    return m_editor.colourTarget().kind() == ColourTarget::Kind::Brush ? m_used : m_editor.brush().colour;
}

void ColourPanel::refresh()
{
    const ColourTarget &target = m_editor.colourTarget();
    const Colour colour = target.colour();
    const bool ofBrush = target.kind() == ColourTarget::Kind::Brush;
    const ColourSummary summary = target.kind() == ColourTarget::Kind::Selection ? target.selected() : ColourSummary();
    const bool isOneOfSeveral = showsNone();
    const auto differs = [&](std::size_t channel) { // The opacity is set for itself, whatever the mode.
        return summary.differ[channel] && (channel == ColourRows::Opacity || isOneOfSeveral);
    };
    m_hint->showHint({}); // Whatever was refused, this is the colour now.
    m_wheel->setColour(colour, isOneOfSeveral);
    m_rows->setColour(colour);
    m_rows->setOneOfSeveral({differs(0), differs(1), differs(2), differs(ColourRows::Opacity)});
    m_screenRows->setColour(colour);
    m_screenRows->setOneOfSeveral(isOneOfSeveral, differs(ColourRows::Opacity));
    m_current->setColour(colour);
    m_current->setOther(summary.other);
    m_current->setToolTip(ofBrush ? tr("The colour that is painted with") : m_header->text());
    m_previous->setColour(beside());
    m_previous->setAccessibleName(ofBrush ? tr("Previous colour") : tr("Colour of the brush"));
    m_previous->setToolTip(ofBrush ? tr("The colour painted with last. Click: back to it.")
                                   : tr("The colour of the brush. Click: take it."));
    showHex();
}

/// Where several colours are selected and all are to become one, none of them is shown as if all had it. To shift them
/// the one is needed from which they are shifted.
bool ColourPanel::showsNone() const
{
    const ColourTarget &target = m_editor.colourTarget();
    return target.isOneOfSeveral() && target.mode() == ColourTarget::Mode::Set;
}

void ColourPanel::showHex()
{
    m_hex->setPlaceholderText(showsNone() ? tr("several") : QString());
    m_hex->showText(showsNone() ? QString() : hexOf(m_editor.colourTarget().colour()));
}

void ColourPanel::takeHex(const QString &text)
{
    if (const std::optional<Colour> colour = typedColour(text)) {
        m_hint->showHint({});
        m_editor.colourTarget().setPaint(*colour);
    } else {
        m_hint->showRefusal(tr("“%1” is not a colour. Write it as #rrggbb, for example #2f6690.").arg(text));
        keepInSight(*m_hex);
        m_hex->refuse();
    }
    showHex();
}

void ColourPanel::rememberUsed()
{
    const Colour colour = m_editor.brush().colour;
    if (colour == m_used && !m_recent.empty())
        return;
    m_used = colour;
    m_previous->setColour(beside());
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
