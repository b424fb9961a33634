#include "app/panels/inspector/picture_section.h"

#include "app/session/editor.h"
#include "app/session/files/image_layer.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/look/section.h"
#include "model/shaping/picture_stroke.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

PictureSection::PictureSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(sectionTitle(tr("Picture"), this));
    m_size = quietLabel({}, this);
    m_file = quietLabel({}, this);
    m_linked = new QCheckBox(tr("Linked to a file"), this);
    m_linked->setToolTip(
        tr("The painting names the picture's file, and does not hold the picture itself. Otherwise the "
           "picture is in the painting, whatever becomes of the file."));
    for (QWidget *widget : std::initializer_list<QWidget *>{m_size, m_file, m_linked})
        column->addWidget(widget);
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_relink = new QPushButton(tr("Relink…"), this);
    m_relink->setToolTip(tr("Another file, or the same one where it lies now, in the picture's place"));
    m_proportions = new QPushButton(tr("Reset Proportions"), this);
    m_proportions->setToolTip(tr("As high and wide as its pixels ask for: its top left corner, its direction and its "
                                 "width stay."));
    row->addWidget(m_relink);
    row->addWidget(m_proportions);
    column->addLayout(row);
    connect(m_linked, &QCheckBox::clicked, this, [this](bool on) {
        if (on)
            choose();
        else
            image_layer::embed(m_editor);
        refresh(inspect(m_editor.document())); // If no file was chosen, the switch goes back.
    });
    connect(m_relink, &QPushButton::clicked, this, &PictureSection::choose);
    connect(m_proportions, &QPushButton::clicked, this, [this] { image_layer::resetProportions(m_editor); });
}

void PictureSection::choose()
{
    if (const QString path = choosePicture(this, tr("Link picture")); !path.isEmpty())
        linkTo(path);
}

void PictureSection::linkTo(const QString &path)
{
    emit refused(image_layer::link(m_editor, path));
}

void PictureSection::refresh(const Inspected &inspected)
{
    std::vector<const Picture *> pictures;
    for (const Stroke *stroke : inspected.strokes)
        if (stroke->picture)
            pictures.push_back(&*stroke->picture);
    setVisible(!pictures.empty());
    if (pictures.empty())
        return;
    const Picture &first = *pictures.front();
    const bool isOne = std::ranges::all_of(
        pictures, [&](const Picture *p) { return p->sha256 == first.sha256 && p->link == first.link; });
    //: width and height of a picture
    m_size->setText(isOne ? tr("%1 × %2 pixels").arg(first.width).arg(first.height)
                          : tr("%n picture(s)", nullptr, int(pictures.size())));
    const auto linked = std::ranges::count_if(pictures, &Picture::isLinked);
    const bool some = linked > 0 && linked < std::ssize(pictures);
    m_linked->setTristate(some);
    m_linked->setCheckState(some ? Qt::PartiallyChecked : linked > 0 ? Qt::Checked : Qt::Unchecked);
    const bool isMissing = std::ranges::any_of(pictures, [](const Picture *p) { return !p->image; });
    // What is missing cannot be taken into the painting.
    m_linked->setEnabled(linked == 0 || !isMissing);
    m_relink->setVisible(linked > 0 || isMissing);
    const QString name = QFileInfo(first.link).fileName();
    QString file = isOne ? name : QString();
    if (isMissing)
        file = isOne && !name.isEmpty() ? tr("%1 is missing or has changed, and is not seen.").arg(name)
                                        : tr("A picture is missing, and is not seen.");
    m_file->setText(file);
    m_file->setVisible(!file.isEmpty());
    m_file->setToolTip(isOne ? QDir::toNativeSeparators(first.link) : QString());
    m_proportions->setEnabled(
        std::ranges::any_of(pictures, [](const Picture *p) { return !(inProportion(*p) == *p); }));
}

} // namespace suffuse
