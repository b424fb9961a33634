#include "app/dialogs/pen_page.h"

#include "app/widgets/brush/pen_pad.h"
#include "app/widgets/curves/response_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// The usual curves, from a light hand's to a heavy one's.
const std::vector<ResponseCurve> &feels()
{
    static const std::vector<ResponseCurve> curves{
        {{{0, 0}, {0.25f, 0.55f}, {1, 1}}}, {{{0, 0}, {1, 1}}}, {{{0, 0}, {0.6f, 0.3f}, {1, 1}}}};
    return curves;
}

} // namespace

PenPage::PenPage(const PenSettings &settings, const Brush &brush, QWidget *parent) : QWidget(parent)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(12);
    auto *head = new QHBoxLayout;
    auto *label = new QLabel(tr("Pressure"), this);
    m_feel = new QComboBox(this);
    m_feel->addItems({tr("Soft"), tr("Even"), tr("Firm")});
    m_feel->setPlaceholderText(tr("Custom"));
    m_feel->setAccessibleName(tr("Pressure"));
    m_feel->setToolTip(tr("How hard the pen must be pressed, for all brushes."));
    label->setBuddy(m_feel);
    auto *clear = new QPushButton(tr("C&lear"), this);
    clear->setToolTip(tr("Takes a clean sheet."));
    head->addWidget(label);
    head->addWidget(m_feel);
    head->addStretch(1);
    head->addWidget(clear);
    column->addLayout(head);

    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    m_curve = new ResponseEditor(this);
    m_curve->setTexts(tr("↑ paints with"), {}, tr("pressure of the pen →"));
    m_curve->setAccessibleName(tr("Pressure curve"));
    m_curve->setToolTip(tr("Drag the points; click for another; drag one out to take it away."));
    m_curve->setMinimumSize(220, 220);
    m_pad = new PenPad(brush, this);
    m_pad->setToolTip(tr("Paint here with the brush in use; the dot on the curve is the pen's pressure."));
    row->addWidget(m_curve, 1);
    row->addWidget(m_pad, 1);
    column->addLayout(row, 1);

    m_fingers = new QCheckBox(tr("Only the pen and the mouse paint; fingers move the view"), this);
    m_fingers->setToolTip(tr("One finger moves the canvas, two zoom and turn it. Otherwise one finger paints."));
    m_fingers->setChecked(settings.fingersMoveView);
    column->addWidget(m_fingers);

    connect(m_feel, &QComboBox::activated, this, [this](int index) {
        m_curve->setCurve(feels()[std::size_t(index)]);
        m_pad->setCurve(m_curve->curve());
    });
    const auto takeCurve = [this] {
        m_pad->setCurve(m_curve->curve());
        showFeel();
    };
    connect(m_curve, &ResponseEditor::edited, this, takeCurve);
    connect(m_curve, &ResponseEditor::givenUp, this, takeCurve);
    connect(clear, &QPushButton::clicked, m_pad, &PenPad::clear);
    connect(m_pad, &PenPad::pressureReported, m_curve, [this](double pressure) { m_curve->setMark(pressure); });
    connect(m_pad, &PenPad::lifted, m_curve, [this] { m_curve->setMark({}); });
    m_curve->setCurve(settings.pressure);
    m_pad->setCurve(settings.pressure);
    showFeel();
}

PenSettings PenPage::settings() const
{
    return {m_curve->curve(), m_fingers->isChecked()};
}

void PenPage::showFeel()
{
    int index = -1;
    for (std::size_t i = 0; i < feels().size(); ++i)
        if (feels()[i] == m_curve->curve())
            index = int(i);
    m_feel->setCurrentIndex(index);
}

} // namespace suffuse
