#include "app/widgets/colour/mixing_pad.h"

#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"

#include <QButtonGroup>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int tallest = 360;             ///< logical pixels: makes the pad about square in a wide dock
constexpr std::size_t mostMixedStrokes = 200; ///< older strokes lie below them, as a picture
constexpr Microseconds mixingSampleTime = 16'000;
constexpr float pigment = 0.7f; ///< β of the painted strokes
constexpr float uptake = 0.15f; ///< share of the paint below that the rubbing brush takes up with each sample

/// The brush of the pad: soft and wide, and its paint covers.
Brush padBrush(const Colour &colour, bool rubbing)
{
    Brush brush;
    brush.style = {StyleKind::Uniform, {0.4f, 0.12f, 0}};
    brush.mix = rubbing ? Mix{} : Mix{MixMode::Beta, pigment};
    brush.setSpread(rubbing ? 13 : 11);
    brush.colour = colour;
    brush.colour.opacity = rubbing ? 0.7f : 0.9f;
    return brush;
}

/// The colour of a pixel; white outside of the picture.
Colour colourOf(const QImage &image, QPoint pixel)
{
    return image.valid(pixel) ? fromScreen(QColor(image.pixel(pixel))) : Colour{0, 0, 0, 1};
}

Colour between(const Colour &a, const Colour &b, float share)
{
    return {std::lerp(a.red, b.red, share), std::lerp(a.yellow, b.yellow, share), std::lerp(a.blue, b.blue, share), 1};
}

} // namespace

MixingPad::MixingPad(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    setCursor(Qt::CrossCursor);
    endDragsWhenCovered(*this);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(tallest);
}

void MixingPad::setMode(Mode mode)
{
    m_mode = mode;
}

void MixingPad::clear()
{
    m_builder.reset();
    m_strokes.clear();
    draw();
    emit clearChanged();
}

Colour MixingPad::colourAt(QPointF at) const
{
    return colourOf(m_sheet.image(), (at * devicePixelRatioF()).toPoint());
}

void MixingPad::press(QPointF at, double pressure, Mode mode)
{
    m_down = true;
    m_hand = mode;
    if (mode == Mode::Pick)
        return pick(at);
    const bool rubbing = mode == Mode::Rub;
    const Colour colour = rubbing ? colourAt(at) : m_editor.brush().colour;
    m_builder = std::make_unique<StrokeBuilder>(padBrush(colour, rubbing), m_nextId++);
    m_before = m_sheet.image();
    m_carried.clear();
    if (rubbing)
        m_carried.push_back({m_time, colour});
    add(at, pressure);
}

void MixingPad::add(QPointF at, double pressure)
{
    m_time += mixingSampleTime;
    if (m_hand == Mode::Rub) {
        const Colour there = colourOf(m_before, (at * devicePixelRatioF()).toPoint());
        m_carried.push_back({m_time, between(m_carried.back().colour, there, uptake)});
    }
    m_builder->add({.position = {at.x(), at.y()}, .time = m_time, .pressure = float(pressure)});
    draw();
}

void MixingPad::move(QPointF at, double pressure)
{
    if (m_builder)
        add(at, pressure);
    else if (m_down && m_hand == Mode::Pick)
        pick(at);
}

void MixingPad::release()
{
    m_down = false;
    if (!m_builder)
        return;
    m_builder->finish();
    if (StrokePtr stroke = strokeInHand())
        m_strokes.push_back(std::move(stroke));
    m_builder.reset();
    if (m_strokes.size() > mostMixedStrokes)
        m_strokes.erase(m_strokes.begin());
    draw();
    emit clearChanged();
}

/// Gives a rubbed stroke the colours that the brush carried along its way.
StrokePtr MixingPad::strokeInHand() const
{
    const StrokePtr built = m_builder ? m_builder->stroke() : nullptr;
    if (!built || m_hand != Mode::Rub)
        return built;
    auto stroke = std::make_shared<Stroke>(*built);
    auto carried = m_carried.begin();
    for (Segment &segment : stroke->segments) {
        while (std::next(carried) != m_carried.end() && carried->time < segment.born)
            ++carried;
        const float opacity = segment.colour.opacity;
        segment.colour = carried->colour;
        segment.colour.opacity = opacity;
    }
    return stroke;
}

void MixingPad::pick(QPointF at)
{
    Colour colour = colourAt(at);
    colour.opacity = m_editor.brush().colour.opacity;
    m_editor.setColour(colour);
}

void MixingPad::draw()
{
    std::vector<StrokePtr> strokes = m_strokes;
    if (StrokePtr stroke = strokeInHand())
        strokes.push_back(std::move(stroke));
    if (m_sheet.draw(strokes, size(), devicePixelRatioF()))
        update();
}

void MixingPad::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath sheet;
    sheet.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setClipPath(sheet);
    painter.drawImage(rect(), m_sheet.image());
    painter.setClipping(false);
    painter.strokePath(sheet, QPen(hairline(), 1));
}

void MixingPad::resizeEvent(QResizeEvent *)
{
    draw();
}

void MixingPad::mousePressEvent(QMouseEvent *event)
{
    if (m_down || event->source() != Qt::MouseEventNotSynthesized)
        return;
    const bool picks = event->button() == Qt::RightButton || event->modifiers() & Qt::ControlModifier;
    const Mode mode = picks ? Mode::Pick : event->modifiers() & Qt::ShiftModifier ? Mode::Rub : m_mode;
    if (picks || event->button() == Qt::LeftButton)
        press(event->position(), 1, mode);
}

void MixingPad::mouseMoveEvent(QMouseEvent *event)
{
    if (event->source() == Qt::MouseEventNotSynthesized)
        move(event->position(), 1);
}

void MixingPad::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->source() == Qt::MouseEventNotSynthesized && !(event->buttons() & (Qt::LeftButton | Qt::RightButton)))
        release();
}

void MixingPad::tabletEvent(QTabletEvent *event)
{
    event->accept();
    if (event->type() == QEvent::TabletPress && !m_down)
        press(event->position(), event->pressure(), event->modifiers() & Qt::ControlModifier ? Mode::Pick : m_mode);
    else if (event->type() == QEvent::TabletMove && m_down)
        move(event->position(), event->pressure());
    else if (event->type() == QEvent::TabletRelease)
        release();
}

MixingSection::MixingSection(Editor &editor, QWidget *parent) : QWidget(parent)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto *head = new QHBoxLayout;
    head->setSpacing(0);
    head->addWidget(sectionTitle(tr("Mixing"), this), 1);
    m_pad = new MixingPad(editor, this);
    m_pad->setToolTip(tr("Paint colours over each other here. Shift+drag rubs, Ctrl+click picks."));
    auto *modes = new QButtonGroup(this);
    const auto addButton = [&](const char *name, const QString &text, const QString &tip) {
        auto *button = new QToolButton(this);
        button->setIcon(icon(name));
        button->setAutoRaise(true);
        button->setAccessibleName(text);
        button->setToolTip(tip);
        head->addWidget(button);
        return button;
    };
    const auto addMode = [&](MixingPad::Mode mode, const char *name, const QString &text, const QString &tip) {
        QToolButton *button = addButton(name, text, tip);
        button->setCheckable(true);
        button->setChecked(mode == m_pad->mode());
        modes->addButton(button, int(mode));
    };
    addMode(MixingPad::Mode::Paint, "brush", tr("Paint"), tr("Paints with the current colour."));
    addMode(MixingPad::Mode::Rub, "rub", tr("Rub"), tr("Carries the paint under the pointer along."));
    addMode(MixingPad::Mode::Pick, "eyedropper", tr("Pick"), tr("Makes the colour under the pointer the current one."));
    head->addSpacing(8);
    m_clear = addButton("delete", tr("Clear"), tr("Takes a clean sheet."));
    m_clear->setEnabled(false);
    column->addLayout(head);
    column->addWidget(m_pad, 1);
    column->addStretch();
    connect(modes, &QButtonGroup::idClicked, this, [this](int mode) { m_pad->setMode(MixingPad::Mode(mode)); });
    connect(m_clear, &QToolButton::clicked, m_pad, &MixingPad::clear);
    connect(m_pad, &MixingPad::clearChanged, this, [this] { m_clear->setEnabled(!m_pad->isClear()); });
}

} // namespace suffuse
