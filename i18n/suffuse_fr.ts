<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Bench</name>
    <message>
        <source>stopped before all was measured</source>
        <translation>arrêté avant d’avoir tout mesuré</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>impossible de créer un dossier temporaire : %1. Donnez à TMPDIR un dossier accessible en écriture.</translation>
    </message>
    <message>
        <source>there is no stroke to drag in this painting</source>
        <translation>ce tableau ne contient aucun trait à faire glisser</translation>
    </message>
    <message>
        <source>measuring %1</source>
        <translation>mesure de %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparé</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>tableau</translation>
    </message>
    <message>
        <source>size</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>backend</source>
        <translation>moteur</translation>
    </message>
    <message>
        <source>device</source>
        <translation>périphérique</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>médiane ms</translation>
    </message>
    <message>
        <source>min ms</source>
        <translation>min. ms</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>passes</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>rapport</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Ink wash</source>
        <translation>Lavis d’encre</translation>
    </message>
    <message>
        <source>Watercolour edge</source>
        <translation>Bord d’aquarelle</translation>
    </message>
    <message>
        <source>Soft airbrush</source>
        <translation>Aérographe doux</translation>
    </message>
    <message>
        <source>Flat marker</source>
        <translation>Marqueur plat</translation>
    </message>
    <message>
        <source>Dry chalk</source>
        <translation>Craie sèche</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Crayon</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>Feutre pinceau</translation>
    </message>
    <message>
        <source>Dry brush</source>
        <translation>Pinceau sec</translation>
    </message>
    <message>
        <source>Ink splash</source>
        <translation>Éclaboussures</translation>
    </message>
    <message>
        <source>Broad nib</source>
        <translation>Plume large</translation>
    </message>
    <message>
        <source>Flat wash</source>
        <translation>Lavis uniforme</translation>
    </message>
    <message>
        <source>Granulating wash</source>
        <translation>Lavis granulant</translation>
    </message>
    <message>
        <source>Wet in wet</source>
        <translation>Mouillé sur mouillé</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>Glacis</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>Deux tons</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Fusain</translation>
    </message>
    <message>
        <source>Pastel</source>
        <translation>Pastel</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>Gouache</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>Lueur</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Encre</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>Aquarelle</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>Sec</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Aplat</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Aérographe</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Round wash</source>
        <translation>Lavis rond</translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Ne pas enregistrer</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Oui</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Non</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Appliquer</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>&amp;Réessayer</translation>
    </message>
    <message>
        <source>Restore &amp;Defaults</source>
        <translation>Rétablir les valeurs par &amp;défaut</translation>
    </message>
    <message>
        <source>&amp;Show Details...</source>
        <translation>Afficher les &amp;détails...</translation>
    </message>
    <message>
        <source>&amp;Hide Details...</source>
        <translation>Masquer les &amp;détails...</translation>
    </message>
</context>
<context>
    <name>ChoosePicture</name>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Pictures and diffusion curves</source>
        <translation>Images et courbes de diffusion</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>%1: cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1 : lecture impossible (%2). Vérifiez le nom et les droits d’accès.</translation>
    </message>
    <message>
        <source>%1: has more than 2 GB; that is more than can be opened</source>
        <translation>%1 : dépasse 2 Go ; c’est plus que ce qui peut être ouvert</translation>
    </message>
    <message>
        <source>  bytes     %1</source>
        <translation>  octets    %1</translation>
    </message>
    <message>
        <source>  canvas    %1 × %2</source>
        <translation>  canevas   %1 × %2</translation>
    </message>
    <message>
        <source>  on paper  %1 × %2 mm, %3 units an inch</source>
        <translation>  imprimé   %1 × %2 mm, %3 unités par pouce</translation>
    </message>
    <message>
        <source>  strokes   %1</source>
        <translation>  traits    %1</translation>
    </message>
    <message>
        <source>  segments  %1</source>
        <translation>  segments  %1</translation>
    </message>
    <message>
        <source>  bounds    none: nothing is painted</source>
        <translation>  limites   aucune : rien n’est peint</translation>
    </message>
    <message>
        <source>  bounds    x %1, y %2, %3 × %4</source>
        <translation>  limites   x %1, y %2, %3 × %4</translation>
    </message>
    <message>
        <source>  duration  %1 s</source>
        <translation>  durée     %1 s</translation>
    </message>
    <message>
        <source>  chunk     %1, %2 bytes</source>
        <translation>  bloc      %1, %2 octets</translation>
    </message>
    <message>
        <source>%1not available: %2</source>
        <translation>%1non disponible : %2</translation>
    </message>
    <message>
        <source>Tells what a painting or a recording holds.</source>
        <translation>Dit ce que contient un tableau ou un enregistrement.</translation>
    </message>
    <message>
        <source>Prints JSON (docs/cli.md).</source>
        <translation>Affiche du JSON (docs/cli.md).</translation>
    </message>
    <message>
        <source>The backends and devices there are, and why one is missing.</source>
        <translation>Les moteurs et périphériques présents, et pourquoi il en manque un.</translation>
    </message>
    <message>
        <source>give a file, or --backends</source>
        <translation>indiquez un fichier, ou --backends</translation>
    </message>
    <message>
        <source>draw a painting into an image file</source>
        <translation>dessiner un tableau dans un fichier image</translation>
    </message>
    <message>
        <source>what a file holds; the backends there are</source>
        <translation>ce que contient un fichier ; les moteurs présents</translation>
    </message>
    <message>
        <source>between documents, the text form and recordings</source>
        <translation>entre documents, forme textuelle et enregistrements</translation>
    </message>
    <message>
        <source>what lies at a point of the canvas</source>
        <translation>ce qui se trouve en un point du canevas</translation>
    </message>
    <message>
        <source>compare the backends with the reference</source>
        <translation>comparer les moteurs avec la référence</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli COMMAND [options] …</source>
        <translation>Usage : suffuse-cli COMMANDE [options] …</translation>
    </message>
    <message>
        <source>%1: there is no such command. See suffuse-cli --help.</source>
        <translation>%1 : cette commande n’existe pas. Voir suffuse-cli --help.</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Affiche cette aide.</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>trop peu d’arguments</translation>
    </message>
    <message>
        <source>one argument too many: %1</source>
        <translation>un argument de trop : %1</translation>
    </message>
    <message>
        <source>%1: %2. See suffuse-cli %1 --help.</source>
        <translation>%1 : %2. Voir suffuse-cli %1 --help.</translation>
    </message>
    <message>
        <source>standard output cannot be written: %1</source>
        <translation>impossible d’écrire sur la sortie standard : %1</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>arrêté ; rien n’a été écrit</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>mémoire insuffisante pour %1 × %2 pixels. Choisissez une taille plus petite.</translation>
    </message>
    <message>
        <source>--area %1: give X,Y,W,H in canvas units, W and H above 0</source>
        <translation>--area %1 : indiquez X,Y,W,H en unités de canevas, W et H supérieurs à 0</translation>
    </message>
    <message>
        <source>--size %1: give WxH or W in pixels, e.g. 1024x768</source>
        <translation>--size %1 : indiquez WxH ou W en pixels, p. ex. 1024x768</translation>
    </message>
    <message>
        <source>--scale %1: give pixels a unit, above 0, e.g. 2</source>
        <translation>--scale %1 : indiquez des pixels par unité, plus de 0, p. ex. 2</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a smaller --size, --scale or --area</source>
        <translation>une image de %1 × %2 pixels est trop grande : au plus %3 millions de pixels. Réduisez --size, --scale ou --area</translation>
    </message>
    <message>
        <source>%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale or --area</source>
        <translation>%1 pixels par unité sont hors limites : de 0.001 à 1e9. Choisissez une autre valeur de --size, --scale ou --area</translation>
    </message>
    <message>
        <source>give --size or --scale, not both</source>
        <translation>indiquez --size ou --scale, pas les deux</translation>
    </message>
    <message>
        <source>--size %1: the picture is scaled uniformly, so a width of %2 has the height %3: use --size %2x%3</source>
        <translation>--size %1 : l’image est mise à l’échelle uniformément, une largeur de %2 a donc la hauteur %3 : utilisez --size %2x%3</translation>
    </message>
    <message>
        <source>--time %1: give a moment in seconds, e.g. 1.5</source>
        <translation>--time %1 : indiquez un moment en secondes, p. ex. 1.5</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu, cuda or reference</source>
        <translation>--backend %1 : indiquez auto, cpu, cuda ou reference</translation>
    </message>
    <message>
        <source>--threads %1: give a number from 1 to 1024</source>
        <translation>--threads %1 : indiquez un nombre de 1 à 1024</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>trait %1</translation>
    </message>
    <message>
        <source>stroke %1, %2</source>
        <translation>trait %1, %2</translation>
    </message>
    <message>
        <source>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (red, yellow, blue, opacity)
  after it: RYB %7, RGB %8
</source>
        <translation>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (rouge, jaune, bleu, opacité)
  après lui : RJB %7, RVB %8
</translation>
    </message>
    <message>
        <source>  fill: φ %1, share %2
</source>
        <translation>  remplissage : φ %1, part %2
</translation>
    </message>
    <message>
        <source>  segment %1: φ %2, share %3
</source>
        <translation>  segment %1 : φ %2, part %3
</translation>
    </message>
    <message>
        <source>at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6
</source>
        <translation>en %1, %2, à %3 s : papier η %4, arrière-plan RJB %5, RVB %6
</translation>
    </message>
    <message>
        <source>no stroke reaches this point
</source>
        <translation>aucun trait n’atteint ce point
</translation>
    </message>
    <message>
        <source>Tells what lies at a point of the canvas, stroke by stroke from bottom to top. X and Y are in canvas units.</source>
        <translation>Dit ce qui se trouve en un point du canevas, trait par trait, de bas en haut. X et Y sont en unités de canevas.</translation>
    </message>
    <message>
        <source>The moment, in seconds (default: the end).</source>
        <translation>Le moment, en secondes (par défaut : la fin).</translation>
    </message>
    <message>
        <source>%1 %2: give X and Y as numbers, in canvas units</source>
        <translation>%1 %2 : indiquez X et Y en nombres, en unités de canevas</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone; scales uniformly.</source>
        <translation>Pixels : WxH, ou W seul ; échelle uniforme.</translation>
    </message>
    <message>
        <source>Pixels a canvas unit (default 1).</source>
        <translation>Pixels par unité de canevas (par défaut 1).</translation>
    </message>
    <message>
        <source>Part of the canvas, in canvas units (default: all of it).</source>
        <translation>Partie du canevas, en unités de canevas (par défaut : tout).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: the end).</source>
        <translation>Le moment dessiné, en secondes (par défaut : la fin).</translation>
    </message>
    <message>
        <source>No background: alpha holds the coverage.</source>
        <translation>Sans arrière-plan : l’alpha contient la couverture.</translation>
    </message>
    <message>
        <source>8, 16, half or float (default: the format&apos;s usual one).</source>
        <translation>8, 16, half ou float (par défaut : selon le format).</translation>
    </message>
    <message>
        <source>auto, cpu, cuda or reference.</source>
        <translation>auto, cpu, cuda ou reference.</translation>
    </message>
    <message>
        <source>Number of threads (default: one a core).</source>
        <translation>Nombre de threads (par défaut : un par cœur).</translation>
    </message>
    <message>
        <source>Prints times and counts as JSON.</source>
        <translation>Affiche les durées et les nombres en JSON.</translation>
    </message>
    <message>
        <source>--depth %1: give 8, 16, half or float</source>
        <translation>--depth %1 : indiquez 8, 16, half ou float</translation>
    </message>
    <message>
        <source>Draws a painting or a recording into an image file.</source>
        <translation>Dessine un tableau ou un enregistrement dans un fichier image.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the picture to write</source>
        <translation>-o OUT manque : nommez l’image à écrire</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference R %3, G %4, B %5</source>
        <translation>%1 et %2 : plus grande différence R %3, V %4, B %5</translation>
    </message>
    <message>
        <source>  at pixel %1, %2: RGB %3 and %4</source>
        <translation>  au pixel %1, %2 : RVB %3 et %4</translation>
    </message>
    <message>
        <source>  %1 of %2 pixels over 1/512</source>
        <translation>  %1 pixels sur %2 au-dessus de 1/512</translation>
    </message>
    <message>
        <source>  %1 pixels that are no numbers</source>
        <translation>  %1 pixels qui ne sont pas des nombres</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference in 8 bits %3, at pixel %4, %5</source>
        <translation>%1 et %2 : plus grande différence en 8 bits %3, au pixel %4, %5</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, at %4 s</source>
        <translation>%1, %2 × %3 pixels, à %4 s</translation>
    </message>
    <message>
        <source>within the contract</source>
        <translation>dans les limites convenues</translation>
    </message>
    <message>
        <source>OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends</source>
        <translation>HORS des limites convenues : 1/512 par rapport à la référence, 1 niveau sur 8 bits entre moteurs</translation>
    </message>
    <message>
        <source>Draws a painting on every backend there is and on the reference, and compares the pictures.</source>
        <translation>Dessine un tableau avec chaque moteur présent et avec la référence, et compare les images.</translation>
    </message>
    <message>
        <source>Prints the rows as a JSON array.</source>
        <translation>Affiche les lignes sous forme de tableau JSON.</translation>
    </message>
    <message>
        <source>Measures on this document instead of a generated painting of figure 11f&apos;s size.</source>
        <translation>Mesure sur ce document au lieu d’un tableau généré de la taille de la figure 11f.</translation>
    </message>
    <message>
        <source>all: every backend that can run here, one after the other.</source>
        <translation>all : chaque moteur qui fonctionne ici, l’un après l’autre.</translation>
    </message>
    <message>
        <source>Numbers of threads; several: full renders with each (default: 1, and one a core).</source>
        <translation>Nombres de threads ; plusieurs : rendus complets avec chacun (par défaut : 1, et un par cœur).</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).</source>
        <translation>Pixels : WxH, ou W seul (par défaut : 1 px par unité, et rendus complets à 2.8125 px aussi).</translation>
    </message>
    <message>
        <source>Names of rows, with commas between: takes these only.</source>
        <translation>Noms de lignes, séparés par des virgules : ne prend que celles-ci.</translation>
    </message>
    <message>
        <source>Runs a row (default: 9).</source>
        <translation>Passes par ligne (par défaut : 9).</translation>
    </message>
    <message>
        <source>Full renders of all thirteen sizes of the paper&apos;s Table 2 too.</source>
        <translation>Ajoute les rendus complets dans les treize tailles du tableau 2 de l’article.</translation>
    </message>
    <message>
        <source>Range of the generated strokes&apos; spread, in units (default: 6 20).</source>
        <translation>Plage d’étalement des traits générés, en unités (par défaut : 6 20).</translation>
    </message>
    <message>
        <source>Segments of the growth rows (default: 1000,10000,100000).</source>
        <translation>Segments des lignes de croissance (par défaut : 1000,10000,100000).</translation>
    </message>
    <message>
        <source>A growth row of 1000000 segments too.</source>
        <translation>Ajoute une ligne de croissance de 1000000 segments.</translation>
    </message>
    <message>
        <source>Width of the generated painting&apos;s canvas (default: 1024).</source>
        <translation>Largeur du canevas du tableau généré (par défaut : 1024).</translation>
    </message>
    <message>
        <source>Height of the generated painting&apos;s canvas (default: 768).</source>
        <translation>Hauteur du canevas du tableau généré (par défaut : 768).</translation>
    </message>
    <message>
        <source>Scale of the generated strokes (default: width / 1024).</source>
        <translation>Échelle des traits générés (par défaut : largeur / 1024).</translation>
    </message>
    <message>
        <source>--%1 %2: give whole numbers from %3 to %4</source>
        <translation>--%1 %2 : indiquez des nombres entiers de %3 à %4</translation>
    </message>
    <message>
        <source>--%1 %2: give a number above 0, at most %3</source>
        <translation>--%1 %2 : indiquez un nombre supérieur à 0, au plus %3</translation>
    </message>
    <message>
        <source>--spread %1: give two numbers, e.g. --spread 6 20</source>
        <translation>--spread %1 : indiquez deux nombres, p. ex. --spread 6 20</translation>
    </message>
    <message>
        <source>--devices %1: give all, or leave it out</source>
        <translation>--devices %1 : indiquez all, ou omettez l’option</translation>
    </message>
    <message>
        <source>--only %1: the rows are %2</source>
        <translation>--only %1 : les lignes sont %2</translation>
    </message>
    <message>
        <source>Measures how fast this machine draws: the figures of docs/performance.md.</source>
        <translation>Mesure la vitesse à laquelle cette machine dessine : les chiffres de docs/performance.md.</translation>
    </message>
    <message>
        <source>measure how fast this machine draws</source>
        <translation>mesurer la vitesse à laquelle cette machine dessine</translation>
    </message>
    <message>
        <source>--devices %1: give all, or a number of GPUs, at least 1</source>
        <translation>--devices %1 : indiquez all, ou un nombre de GPU, au moins 1</translation>
    </message>
    <message>
        <source>--devices is for CUDA: use it with --backend cuda</source>
        <translation>--devices concerne CUDA : utilisez-le avec --backend cuda</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the picture, all or a number (default 1).</source>
        <translation>Avec CUDA : GPU qui se partagent l’image, all ou un nombre (par défaut 1).</translation>
    </message>
    <message>
        <source>draw a painting while it is painted, as frames</source>
        <translation>dessiner un tableau pendant qu’il se peint, en images successives</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>encore %n s</numerusform>
            <numerusform>encore %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>Frames a second (default 25).</source>
        <translation>Images par seconde (par défaut 25).</translation>
    </message>
    <message>
        <source>Length in seconds (default 10).</source>
        <translation>Durée en secondes (par défaut 10).</translation>
    </message>
    <message>
        <source>Seconds that are kept of a pause in the painting (default 0.5).</source>
        <translation>Secondes conservées d’une pause pendant la peinture (par défaut 0.5).</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the frames, all or a number (default 1).</source>
        <translation>Avec CUDA : GPU qui se partagent les images, all ou un nombre (par défaut 1).</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to 1000000</source>
        <translation>--%1 %2 : indiquez un nombre de %3 à 1000000</translation>
    </message>
    <message>
        <source>%1 frames are too many: at most %2. Choose a smaller --fps or --duration</source>
        <translation>%1 images, c’est trop : au plus %2. Réduisez --fps ou --duration</translation>
    </message>
    <message>
        <source>Draws a painting while it is painted, frame by frame.</source>
        <translation>Dessine un tableau pendant qu’il se peint, image par image.</translation>
    </message>
    <message>
        <source>--brush %1: there is no such brush nor file; choose a file or one of %2</source>
        <translation>--brush %1 : ce pinceau ou ce fichier n’existe pas ; choisissez un fichier ou l’un de %2</translation>
    </message>
    <message>
        <source>Frames with their number, film/%05d.png; or film.webp, .webm or .mp4.</source>
        <translation>Images avec leur numéro, film/%05d.png ; ou film.webp, .webm ou .mp4.</translation>
    </message>
    <message>
        <source>WebP: plays once instead of again and again.</source>
        <translation>WebP : une seule lecture au lieu d’une boucle.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the frames or the film to write</source>
        <translation>-o OUT manque : nommez les images ou le film à écrire</translation>
    </message>
    <message>
        <source>Leaves out what lies beside the picture: preview, view, undo history.</source>
        <translation>Omet ce qui accompagne le tableau : aperçu, vue, historique d’annulation.</translation>
    </message>
    <message>
        <source>Of a damaged document takes what is whole, and says what is missing.</source>
        <translation>D’un document endommagé, prend ce qui est intact et dit ce qui manque.</translation>
    </message>
    <message>
        <source>%1: is damaged; --salvage writes what is whole of it</source>
        <translation>%1 : est endommagé ; --salvage écrit ce qui en est intact</translation>
    </message>
    <message>
        <source>segments added: %1</source>
        <translation>segments ajoutés : %1</translation>
    </message>
    <message>
        <source>segments removed: %1</source>
        <translation>segments supprimés : %1</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same painting</source>
        <translation>%1 et %2 contiennent le même tableau</translation>
    </message>
    <message>
        <source>%1, segments: %2</source>
        <translation>%1, segments : %2</translation>
    </message>
    <message>
        <source>%1: from place %2 to %3</source>
        <translation>%1 : de la place %2 à %3</translation>
    </message>
    <message>
        <source>Compares two paintings and tells what was added, removed and changed from A to B.</source>
        <translation>Compare deux tableaux et dit ce qui a été ajouté, supprimé et modifié de A à B.</translation>
    </message>
    <message>
        <source>only one of the two can be standard input</source>
        <translation>un seul des deux peut être l’entrée standard</translation>
    </message>
    <message>
        <source>A picture that shows where: B pale, added strokes green, removed ones orange, changed and moved ones blue.</source>
        <translation>Une image qui montre où : B pâle, traits ajoutés en vert, supprimés en orange, modifiés et déplacés en bleu.</translation>
    </message>
    <message>
        <source>--%1 is for the picture; give -o OUT too</source>
        <translation>--%1 concerne l’image ; indiquez aussi -o OUT</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>aperçu</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>la dernière vue</translation>
    </message>
    <message>
        <source>undo history</source>
        <translation>historique d’annulation</translation>
    </message>
    <message>
        <source>colour profile</source>
        <translation>profil de couleur</translation>
    </message>
    <message>
        <source>size on paper</source>
        <translation>taille sur papier</translation>
    </message>
    <message>
        <source>unknown to this version, kept</source>
        <translation>inconnu de cette version, conservé</translation>
    </message>
    <message>
        <source>  chunk     %1 at byte %2 is damaged: %3</source>
        <translation>  bloc      %1 à l’octet %2 est endommagé : %3</translation>
    </message>
    <message>
        <source>  paper     %1</source>
        <translation>  papier    %1</translation>
    </message>
    <message>
        <source>what differs between two paintings, and where</source>
        <translation>ce qui diffère entre deux tableaux, et où</translation>
    </message>
    <message>
        <source>what was not saved when the editor ended</source>
        <translation>ce qui n’était pas enregistré quand l’éditeur s’est arrêté</translation>
    </message>
    <message>
        <source>in use by a running Suffuse</source>
        <translation>utilisé par une instance de Suffuse en cours d’exécution</translation>
    </message>
    <message>
        <source>There is nothing to recover.
</source>
        <translation>Il n’y a rien à récupérer.
</translation>
    </message>
    <message>
        <source>Lists what was painted and not saved when Suffuse ended unexpectedly, or writes one of it to a file.</source>
        <translation>Énumère ce qui a été peint sans être enregistré quand Suffuse s’est arrêté de façon inattendue, ou en écrit un élément dans un fichier.</translation>
    </message>
    <message>
        <source>Lists what there is; the same as no ID.</source>
        <translation>Énumère ce qu’il y a ; revient à ne donner aucun ID.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json.</source>
        <translation>Le fichier à écrire : .suffuse ou .json.</translation>
    </message>
    <message>
        <source>give an ID and -o OUT, or neither</source>
        <translation>indiquez un ID et -o OUT, ou ni l’un ni l’autre</translation>
    </message>
    <message>
        <source>%1: there is no such journal to recover. See suffuse-cli recover --list.</source>
        <translation>%1 : ce journal à récupérer n’existe pas. Voir suffuse-cli recover --list.</translation>
    </message>
    <message>
        <source>The brush that recordings and drawings are painted with: a name, or a brush file.</source>
        <translation>Le pinceau avec lequel peindre enregistrements et dessins : un nom, ou un fichier de pinceau.</translation>
    </message>
    <message>
        <source>%1: is IN itself, which would be lost; give OUT another name</source>
        <translation>%1 : c’est IN lui-même, qui serait perdu ; donnez un autre nom à OUT</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read; -: standard input.</source>
        <translation>Le tableau, l’enregistrement ou le dessin à lire ; - : entrée standard.</translation>
    </message>
    <message>
        <source>The painting before; -: standard input.</source>
        <translation>Le tableau avant ; - : entrée standard.</translation>
    </message>
    <message>
        <source>The painting after; -: standard input.</source>
        <translation>Le tableau après ; - : entrée standard.</translation>
    </message>
    <message>
        <source>How far right of the canvas&apos; left edge, in canvas units.</source>
        <translation>À quelle distance à droite du bord gauche du canevas, en unités de canevas.</translation>
    </message>
    <message>
        <source>How far below the canvas&apos; upper edge, in canvas units.</source>
        <translation>À quelle distance sous le bord supérieur du canevas, en unités de canevas.</translation>
    </message>
    <message>
        <source>Which one, as the list names it.</source>
        <translation>Lequel, tel que la liste le nomme.</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli %1 [options]</source>
        <translation>Usage : suffuse-cli %1 [options]</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 est indiqué deux fois ; indiquez-le une seule fois</translation>
    </message>
    <message>
        <source>--time %1: nothing is painted before %2 s</source>
        <translation>--time %1 : rien n’est peint avant %2 s</translation>
    </message>
    <message>
        <source>--format is for an OUT of -; the ending of %1 chooses the format</source>
        <translation>--format sert quand OUT est - ; l’extension de %1 choisit le format</translation>
    </message>
    <message>
        <source>--brush is ignored: the strokes of %1 have their looks already</source>
        <translation>--brush est ignoré : les traits de %1 ont déjà leur aspect</translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1 : son trait (%n) n’est pas intact ; ouvrez-en une sauvegarde</numerusform>
            <numerusform>%1 : aucun de ses %n traits n’est intact ; ouvrez-en une sauvegarde</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2: %3, %4 removed, %5 changed, %6 moved</source>
        <translation>%1 → %2 : %3, %4 supprimés, %5 modifiés, %6 déplacés</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>%n trait ajouté</numerusform>
            <numerusform>%n traits ajoutés</numerusform>
        </translation>
    </message>
    <message>
        <source>suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help COMMAND. An input of - is standard input.
Exit codes: 0 done, 1 the work failed, 2 wrong usage.</source>
        <translation>suffuse-cli COMMANDE --help énumère les options d’une commande, tout comme suffuse-cli help COMMANDE. Une entrée - est l’entrée standard.
Codes de sortie : 0 réussi, 1 le travail a échoué, 2 mauvais usage.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json; -: standard output.</source>
        <translation>Le fichier à écrire : .suffuse ou .json ; - : sortie standard.</translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  %n segment d’une part inférieure à %1 omis (--all)
</numerusform>
            <numerusform>  %n segments d’une part inférieure à %1 omis (--all)
</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists segments with shares below a millionth, too.</source>
        <translation>Énumère aussi les segments dont la part est inférieure à un millionième.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n trait</numerusform>
            <numerusform>%n traits</numerusform>
        </translation>
    </message>
    <message>
        <source>-o %1: what is recovered is a painting: give a name that ends in .suffuse or .json. suffuse-cli render draws it then</source>
        <translation>-o %1 : ce qui est récupéré est un tableau : donnez un nom qui se termine par .suffuse ou .json. suffuse-cli render le dessine ensuite</translation>
    </message>
    <message>
        <source>The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: its layers; -: standard output.</source>
        <translation>L’image : .png, .tiff, .exr, .jpg, .webp ou .pfm ; .ora ou .psd : ses calques ; - : sortie standard.</translation>
    </message>
    <message>
        <source>With -o -: png, tiff, exr, jpg, webp or pfm (default: png).</source>
        <translation>Avec -o - : png, tiff, exr, jpg, webp ou pfm (par défaut : png).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100.</source>
        <translation>Pour JPEG et WebP, de 1 à 100 (par défaut 92) ; à 100, WebP est sans perte.</translation>
    </message>
    <message>
        <source>Pixels an inch, as the file says it (default: what makes the picture as large on paper as IN says that it is; else it says nothing).</source>
        <translation>Pixels par pouce, tels que le fichier les indique (par défaut : ce qu’il faut pour que l’image soit aussi grande sur papier que IN le dit ; sinon, il n’indique rien).</translation>
    </message>
    <message>
        <source>--format is for -o -; the ending of %1 chooses the format</source>
        <translation>--format sert avec -o - ; l’extension de %1 choisit le format</translation>
    </message>
    <message>
        <source>--stats and -o - both write to standard output; give one</source>
        <translation>--stats et -o - écrivent tous deux sur la sortie standard ; n’en indiquez qu’un</translation>
    </message>
    <message>
        <source>standard output is a terminal, which shows no pictures; lead it into a file or a program</source>
        <translation>la sortie standard est un terminal, qui n’affiche pas d’images ; redirigez-la vers un fichier ou un programme</translation>
    </message>
    <message>
        <source>--format %1: give one of %2</source>
        <translation>--format %1 : indiquez l’un de %2</translation>
    </message>
    <message>
        <source>--quality %1: give a whole number from 1 to 100</source>
        <translation>--quality %1 : indiquez un nombre entier de 1 à 100</translation>
    </message>
    <message>
        <source>--quality is ignored: %1 loses nothing</source>
        <translation>--quality est ignoré : %1 est sans perte</translation>
    </message>
    <message>
        <source>--dpi %1: give a number from 1 to 10000, e.g. 300</source>
        <translation>--dpi %1 : indiquez un nombre de 1 à 10000, p. ex. 300</translation>
    </message>
    <message>
        <source>--dpi is ignored: %1 files hold no resolution</source>
        <translation>--dpi est ignoré : les fichiers %1 ne contiennent pas de résolution</translation>
    </message>
    <message>
        <source>  segment %1 fades: φ %2, which leaves %3
</source>
        <translation>  le segment %1 atténue : φ %2, il en reste %3
</translation>
    </message>
    <message>
        <source>  segment %1 lifts: φ %2, share %3
</source>
        <translation>  le segment %1 éponge : φ %2, part %3
</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sans titre</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, is missing or of another version, so texts are left out; install Suffuse again, with what suffuse-cli recommends</source>
        <translation>un composant de Suffuse, %1, manque ou est d’une autre version, les textes sont donc omis ; réinstallez Suffuse, avec ce que suffuse-cli recommande</translation>
    </message>
    <message>
        <source>  groups    %1</source>
        <translation>  groupes   %1</translation>
    </message>
    <message>
        <source>%1 of them blending</source>
        <translation>dont avec mode de fusion : %1</translation>
    </message>
    <message>
        <source>%1 clipped</source>
        <translation>écrêtés : %1</translation>
    </message>
    <message>
        <source>%1 masking</source>
        <translation>masques : %1</translation>
    </message>
    <message>
        <source>%1 a wash</source>
        <translation>lavis : %1</translation>
    </message>
    <message>
        <source>--transparent: the background is a layer of its own, which other programs can hide</source>
        <translation>--transparent : l’arrière-plan est un calque à part, que d’autres programmes peuvent masquer</translation>
    </message>
    <message>
        <source>--depth %1: layers have 8 or 16 bits</source>
        <translation>--depth %1 : les calques ont 8 ou 16 bits</translation>
    </message>
    <message>
        <source>--%1 is ignored: it is not for layered files</source>
        <translation>--%1 est ignoré : il n’est pas fait pour les fichiers à calques</translation>
    </message>
    <message>
        <source>drawing layers</source>
        <translation>dessin des calques</translation>
    </message>
    <message>
        <source>there is not enough memory for layers of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>mémoire insuffisante pour des calques de %1 × %2 pixels. Choisissez une taille plus petite.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n groupe aurait un autre aspect dans d’autres programmes ; ses calques montrent à la place ce qu’il fait de l’image</numerusform>
            <numerusform>%n groupes auraient un autre aspect dans d’autres programmes ; leurs calques montrent à la place ce qu’ils font de l’image</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 shown alone</source>
        <translation>montrés seuls : %1</translation>
    </message>
    <message>
        <source>%1 a draft</source>
        <translation>ébauches : %1</translation>
    </message>
    <message>
        <source>  pictures  %1</source>
        <translation>  images    %1</translation>
    </message>
    <message>
        <source>Draws groups that are drafts, too.</source>
        <translation>Dessine aussi les groupes qui sont des ébauches.</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf</source>
        <translation>%1 : extension inconnue ; utilisez .suffuse, .json, .svg, .svgz ou .pdf</translation>
    </message>
    <message>
        <source>Converts between documents (.suffuse) and the text form (.json), and from pen recordings and drawings, and to drawings (.svg, .svgz, .pdf). What IN is, is found from its content; what OUT is, from its ending.</source>
        <translation>Convertit entre documents (.suffuse) et forme textuelle (.json), à partir d’enregistrements au stylet et de dessins, et en dessins (.svg, .svgz, .pdf). La nature de IN se déduit de son contenu ; celle de OUT, de son extension.</translation>
    </message>
    <message>
        <source>--format %1: give suffuse, json, svg or pdf</source>
        <translation>--format %1 : indiquez suffuse, json, svg ou pdf</translation>
    </message>
    <message>
        <source>Where OUT is -: suffuse, json, svg or pdf (default: json).</source>
        <translation>Quand OUT est - : suffuse, json, svg ou pdf (par défaut : json).</translation>
    </message>
    <message>
        <source>--%1 is for drawings; give OUT the ending .svg or .pdf</source>
        <translation>--%1 concerne les dessins ; donnez à OUT l’extension .svg ou .pdf</translation>
    </message>
    <message>
        <source>--as %1: give outlines, bands or hybrid</source>
        <translation>--as %1 : indiquez outlines, bands ou hybrid</translation>
    </message>
    <message>
        <source>--bands %1: give a whole number from 1 to %2</source>
        <translation>--bands %1 : indiquez un nombre entier de 1 à %2</translation>
    </message>
    <message>
        <source>--bands is for --as bands; leave one of them out</source>
        <translation>--bands va avec --as bands ; omettez l’un des deux</translation>
    </message>
    <message>
        <source>Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands (contours within each other, as opaque as the paint; the default) or hybrid (the exact picture under unpainted outlines).</source>
        <translation>Quand OUT est un dessin (.svg, .svgz, .pdf) : outlines (un chemin par trait), bands (contours emboîtés, aussi opaques que la peinture ; par défaut) ou hybrid (l’image exacte sous des contours non peints).</translation>
    </message>
    <message>
        <source>How many bands full opacity has, 1 to 256 (default: 16).</source>
        <translation>Nombre de bandes pour l’opacité totale, de 1 à 256 (par défaut : 16).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: all dried).</source>
        <translation>Le moment dessiné, en secondes (par défaut : tout est sec).</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>ICC profile of RGB colours that the file has (default: sRGB).</source>
        <translation>Profil ICC de couleurs RVB du fichier (par défaut : sRGB).</translation>
    </message>
    <message>
        <source>--profile %1: %2; give an ICC profile of RGB colours</source>
        <translation>--profile %1 : %2 ; indiquez un profil ICC de couleurs RVB</translation>
    </message>
    <message>
        <source>Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, into which the sheet fits (default: the sheet as large as it is on paper; where that is not said, 96 units are an inch).</source>
        <translation>Quand OUT est un PDF : A3, A4, A5, Letter, ou une taille comme 200x150mm ou 8x6in, dans laquelle la feuille s’inscrit (par défaut : la feuille, aussi grande que sur papier ; si cela n’est pas dit, à 96 unités par pouce).</translation>
    </message>
    <message>
        <source>--page is for PDF; give OUT the ending .pdf</source>
        <translation>--page concerne le PDF ; donnez à OUT l’extension .pdf</translation>
    </message>
    <message>
        <source>--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in</source>
        <translation>--page %1 : indiquez A3, A4, A5, Letter, ou une taille comme 200x150mm ou 8x6in</translation>
    </message>
    <message>
        <source>several INs become the pages of a PDF; give OUT the ending .pdf</source>
        <translation>plusieurs IN deviennent les pages d’un PDF ; donnez à OUT l’extension .pdf</translation>
    </message>
    <message>
        <source>%1 is a picture: suffuse-cli render IN -o OUT writes pictures</source>
        <translation>%1 est une image : suffuse-cli render IN -o OUT écrit des images</translation>
    </message>
    <message>
        <source>The painting to write: .suffuse or .json.</source>
        <translation>Le tableau à écrire : .suffuse ou .json.</translation>
    </message>
    <message>
        <source>At most so many strokes (default 512).</source>
        <translation>Nombre maximal de traits (par défaut 512).</translation>
    </message>
    <message>
        <source>At most so many numbers, 27 for each stroke.</source>
        <translation>Nombre maximal de nombres, 27 par trait.</translation>
    </message>
    <message>
        <source>As many strokes as this root mean square error needs, in 255ths.</source>
        <translation>Autant de traits qu’en demande cette erreur quadratique moyenne, en 255es.</translation>
    </message>
    <message>
        <source>So many paints, which become linked swatches.</source>
        <translation>Nombre de peintures, qui deviennent des nuances liées.</translation>
    </message>
    <message>
        <source>feathering (default), uniform or edge.</source>
        <translation>feathering (par défaut), uniform ou edge.</translation>
    </message>
    <message>
        <source>No stroke is narrower, pixels of PICTURE.</source>
        <translation>Aucun trait n’est plus étroit, en pixels de PICTURE.</translation>
    </message>
    <message>
        <source>No stroke is wider, pixels of PICTURE.</source>
        <translation>Aucun trait n’est plus large, en pixels de PICTURE.</translation>
    </message>
    <message>
        <source>Another picture, white where PICTURE counts and black where not.</source>
        <translation>Une autre image, blanche où PICTURE compte et noire où elle ne compte pas.</translation>
    </message>
    <message>
        <source>The share of the error as people see it, 0 (default) to 1.</source>
        <translation>La part de l’erreur telle que l’œil la voit, de 0 (par défaut) à 1.</translation>
    </message>
    <message>
        <source>Goes on with a painting that was fitted before.</source>
        <translation>Continue un tableau déjà ajusté auparavant.</translation>
    </message>
    <message>
        <source>How many steps (default 1200).</source>
        <translation>Nombre d’étapes (par défaut 1200).</translation>
    </message>
    <message>
        <source>PICTURE is averaged down to so many pixels (default 600000).</source>
        <translation>PICTURE est réduite par moyenne à ce nombre de pixels (par défaut 600000).</translation>
    </message>
    <message>
        <source>Other numbers give other strokes (default 1).</source>
        <translation>D’autres nombres donnent d’autres traits (par défaut 1).</translation>
    </message>
    <message>
        <source>Prints how near the painting comes, as JSON (docs/cli.md).</source>
        <translation>Affiche à quel point le tableau s’approche, en JSON (docs/cli.md).</translation>
    </message>
    <message>
        <source>--%1 %2: give a whole number from %3 to %4</source>
        <translation>--%1 %2 : indiquez un nombre entier de %3 à %4</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to %4</source>
        <translation>--%1 %2 : indiquez un nombre de %3 à %4</translation>
    </message>
    <message>
        <source>--style %1: give feathering, uniform or edge</source>
        <translation>--style %1 : indiquez feathering, uniform ou edge</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the painting to write</source>
        <translation>-o OUT manque : nommez le tableau à écrire</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse or .json</source>
        <translation>%1 : extension inconnue ; utilisez .suffuse ou .json</translation>
    </message>
    <message>
        <source>--strokes and --numbers say the same; give one of them</source>
        <translation>--strokes et --numbers disent la même chose ; n’en indiquez qu’un</translation>
    </message>
    <message>
        <source>--style goes without --from, whose strokes have a style already</source>
        <translation>--style ne va pas avec --from, dont les traits ont déjà un style</translation>
    </message>
    <message>
        <source>--greatest-width %1 is below --least-width %2</source>
        <translation>--greatest-width %1 est inférieur à --least-width %2</translation>
    </message>
    <message>
        <source>%1: is a painting already; draw it with suffuse-cli render first</source>
        <translation>%1 : est déjà un tableau ; dessinez-le d’abord avec suffuse-cli render</translation>
    </message>
    <message>
        <source>%1: there is no folder %2</source>
        <translation>%1 : le dossier %2 n’existe pas</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1 : écriture impossible</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>ajustement</translation>
    </message>
    <message>
        <source>stopped; %1 has the strokes so far, and --from %1 goes on</source>
        <translation>arrêté ; %1 contient les traits faits jusqu’ici, et --from %1 continue</translation>
    </message>
    <message>
        <source>Makes strokes that look like a picture, from the back to the front and large before small.</source>
        <translation>Fait des traits qui ressemblent à une image, de l’arrière vers l’avant et les grands avant les petits.</translation>
    </message>
    <message>
        <source>there is not enough memory to fit %1. Choose fewer --pixels.</source>
        <translation>mémoire insuffisante pour ajuster %1. Réduisez --pixels.</translation>
    </message>
    <message>
        <source>make a painting of a picture</source>
        <translation>faire un tableau d’une image</translation>
    </message>
    <message>
        <source>--strokes goes with --fit, which makes strokes of a picture</source>
        <translation>--strokes va avec --fit, qui fait des traits à partir d’une image</translation>
    </message>
    <message>
        <source>--%1 says nothing of a picture that is fitted; leave it out</source>
        <translation>--%1 est sans effet sur une image que l’on ajuste ; omettez-le</translation>
    </message>
    <message>
        <source>--fit takes one IN at a time</source>
        <translation>--fit prend un seul IN à la fois</translation>
    </message>
    <message>
        <source>Solves the diffusion curves of IN, or reads its picture, and makes strokes that look like it, as suffuse-cli fit does.</source>
        <translation>Résout les courbes de diffusion de IN, ou lit son image, et fait des traits qui lui ressemblent, comme suffuse-cli fit.</translation>
    </message>
    <message>
        <source>With --fit: at most so many strokes (default 512).</source>
        <translation>Avec --fit : nombre maximal de traits (par défaut 512).</translation>
    </message>
    <message>
        <source>Also writes the picture that is fitted, as it was read, averaged or solved.</source>
        <translation>Écrit aussi l’image ajustée, telle qu’elle a été lue, moyennée ou résolue.</translation>
    </message>
    <message>
        <source>--target %1: unknown ending; use one of %2</source>
        <translation>--target %1 : extension inconnue ; utilisez l’une de %2</translation>
    </message>
    <message>
        <source>The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: standard input.</source>
        <translation>L’image à lire : PNG, JPEG, TIFF, EXR, WebP ou courbes de diffusion (XML) ; - : entrée standard.</translation>
    </message>
    <message>
        <source>make fewer strokes that look like those of a painting</source>
        <translation>faire moins de traits qui ressemblent à ceux d’un tableau</translation>
    </message>
    <message>
        <source>The strokes to make anew, by their ids, such as 3,7,20-180 (default: all).</source>
        <translation>Les traits à refaire, par leurs identifiants, comme 3,7,20-180 (par défaut : tous).</translation>
    </message>
    <message>
        <source>All strokes of the group of that name, in place of --select.</source>
        <translation>Tous les traits du groupe de ce nom, au lieu de --select.</translation>
    </message>
    <message>
        <source>A picture, or another painting, that the whole is to look like (default: as it does).</source>
        <translation>Une image, ou un autre tableau, à quoi l’ensemble doit ressembler (par défaut : comme il est).</translation>
    </message>
    <message>
        <source>At most so many strokes (default: a quarter of those before).</source>
        <translation>Nombre maximal de traits (par défaut : un quart des précédents).</translation>
    </message>
    <message>
        <source>What the strokes reach is fitted at so many pixels (default 600000).</source>
        <translation>Ce que les traits atteignent est ajusté avec ce nombre de pixels (par défaut 600000).</translation>
    </message>
    <message>
        <source>Says how near the painting comes as JSON (docs/cli.md).</source>
        <translation>Dit en JSON à quel point le tableau s’approche (docs/cli.md).</translation>
    </message>
    <message>
        <source>--select and --layer both say which strokes; give one of them</source>
        <translation>--select et --layer disent tous deux quels traits ; n’en indiquez qu’un</translation>
    </message>
    <message>
        <source>--select %1: give ids of strokes, such as 3,7,20-180</source>
        <translation>--select %1 : indiquez des identifiants de traits, comme 3,7,20-180</translation>
    </message>
    <message>
        <source>--select %1: there is no stroke %2; suffuse-cli convert IN OUT.json shows the ids</source>
        <translation>--select %1 : le trait %2 n’existe pas ; suffuse-cli convert IN OUT.json montre les identifiants</translation>
    </message>
    <message>
        <source>--layer %1: several groups have that name; rename one of them</source>
        <translation>--layer %1 : plusieurs groupes portent ce nom ; renommez-en un</translation>
    </message>
    <message>
        <source>--layer %1: there is no group of that name</source>
        <translation>--layer %1 : aucun groupe ne porte ce nom</translation>
    </message>
    <message>
        <source>%1: is empty</source>
        <translation>%1 : est vide</translation>
    </message>
    <message>
        <source>%1 strokes in place of %2. Where they are seen, the picture is %3 of 255 from what it should be (root mean square), %4 at most.</source>
        <translation>%1 traits au lieu de %2. Là où on les voit, l’image est à %3 sur 255 de ce qu’elle devrait être (moyenne quadratique), à %4 au plus.</translation>
    </message>
    <message>
        <source>Before it was %1, %2 at most.</source>
        <translation>Avant, c’était %1, %2 au plus.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%n trait qui se trouvait entre eux est maintenant dessous.</numerusform>
            <numerusform>%n traits qui se trouvaient entre eux sont maintenant dessous.</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes fewer strokes that look like those of a painting, or makes them look like a picture, and says how near they come.</source>
        <translation>Fait moins de traits qui ressemblent à ceux d’un tableau, ou les fait ressembler à une image, et dit à quel point ils s’approchent.</translation>
    </message>
    <message>
        <source>a small picture of a painting, for file managers</source>
        <translation>une petite image d’un tableau, pour les gestionnaires de fichiers</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read.</source>
        <translation>Le tableau, l’enregistrement ou le dessin à lire.</translation>
    </message>
    <message>
        <source>The PNG file to write; -: standard output.</source>
        <translation>Le fichier PNG à écrire ; - : sortie standard.</translation>
    </message>
    <message>
        <source>So many pixels a side at most, 1 to 1024.</source>
        <translation>Nombre maximal de pixels par côté, de 1 à 1024.</translation>
    </message>
    <message>
        <source>Writes a small picture of a painting as a PNG file: the preview in the file, if it has one. File managers call this.</source>
        <translation>Écrit une petite image d’un tableau en fichier PNG : l’aperçu du fichier, s’il en a un. Les gestionnaires de fichiers appellent cette commande.</translation>
    </message>
    <message>
        <source>%1: give SIDE as a whole number of pixels from 1 to %2</source>
        <translation>%1 : indiquez SIDE en nombre entier de pixels de 1 à %2</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are there</source>
        <translation>%1 morceaux sur %2 sont là</translation>
    </message>
    <message>
        <source>%1: frames %2 are missing</source>
        <translation>%1 : les images %2 manquent</translation>
    </message>
    <message>
        <source>%1: sheets %2 are missing</source>
        <translation>%1 : les planches %2 manquent</translation>
    </message>
    <message>
        <source>%1: two workers made different bits of piece %2. One of the machines is faulty: find it by the names in %3, remove its journal there, and run the tasks again.</source>
        <translation>%1 : deux exécutants ont produit des bits différents pour le morceau %2. L’une des machines est défectueuse : trouvez-la par les noms dans %3, supprimez-y son journal et relancez les tâches.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>joining</source>
        <translation>assemblage</translation>
    </message>
    <message>
        <source>%1: sheet %2 cannot be read any more. Run the tasks again.</source>
        <translation>%1 : la planche %2 n’est plus lisible. Relancez les tâches.</translation>
    </message>
    <message>
        <source>Says what is missing, by what workers wrote down.</source>
        <translation>Dit ce qui manque, d’après ce que les exécutants ont noté.</translation>
    </message>
    <message>
        <source>Says what is missing or damaged, by reading all of it.</source>
        <translation>Dit ce qui manque ou est endommagé, en lisant tout.</translation>
    </message>
    <message>
        <source>Puts the pictures together, once all is there and whole.</source>
        <translation>Assemble les images, une fois que tout est là et intact.</translation>
    </message>
    <message>
        <source>Nothing was joined. Run the tasks again: they draw what is missing.</source>
        <translation>Rien n’a été assemblé. Relancez les tâches : elles dessinent ce qui manque.</translation>
    </message>
    <message>
        <source>say what is to be drawn, in a shared folder</source>
        <translation>dire ce qui est à dessiner, dans un dossier partagé</translation>
    </message>
    <message>
        <source>draw a part of it, on any machine</source>
        <translation>en dessiner une partie, sur n’importe quelle machine</translation>
    </message>
    <message>
        <source>what is missing</source>
        <translation>ce qui manque</translation>
    </message>
    <message>
        <source>read all that is there, and compare the hashes</source>
        <translation>lire tout ce qui est là, et comparer les empreintes</translation>
    </message>
    <message>
        <source>put the pictures together</source>
        <translation>assembler les images</translation>
    </message>
    <message>
        <source>submit the work as a job array of Slurm</source>
        <translation>soumettre le travail à Slurm comme « job array »</translation>
    </message>
    <message>
        <source>print the work as an Open Job Description</source>
        <translation>afficher le travail comme Open Job Description</translation>
    </message>
    <message>
        <source>print the work as a job type of Flamenco</source>
        <translation>afficher le travail comme type de job de Flamenco</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli farm COMMAND [options] …</source>
        <translation>Usage : suffuse-cli farm COMMANDE [options] …</translation>
    </message>
    <message>
        <source>farm %1: there is no such command. See suffuse-cli farm --help.</source>
        <translation>farm %1 : cette commande n’existe pas. Voir suffuse-cli farm --help.</translation>
    </message>
    <message>
        <source>Into how many tasks the work is divided (default: one for 64 pieces).</source>
        <translation>En combien de tâches le travail est divisé (par défaut : une pour 64 morceaux).</translation>
    </message>
    <message>
        <source>--tasks %1: give a whole number, at least 1</source>
        <translation>--tasks %1 : indiquez un nombre entier, au moins 1</translation>
    </message>
    <message>
        <source>sbatch cannot be started: install Slurm (slurm-client), or use --write-only</source>
        <translation>impossible de lancer sbatch : installez Slurm (slurm-client), ou utilisez --write-only</translation>
    </message>
    <message>
        <source>Submits the tasks as a job array, and the joining after it.</source>
        <translation>Soumet les tâches comme « job array », puis l’assemblage.</translation>
    </message>
    <message>
        <source>Cores of each task (default 2).</source>
        <translation>Cœurs par tâche (par défaut 2).</translation>
    </message>
    <message>
        <source>Writes the scripts, and submits nothing.</source>
        <translation>Écrit les scripts et ne soumet rien.</translation>
    </message>
    <message>
        <source>--cpus %1: give a whole number, at least 1</source>
        <translation>--cpus %1 : indiquez un nombre entier, au moins 1</translation>
    </message>
    <message>
        <source>job %1: %2 tasks; job %3 joins what they draw</source>
        <translation>job %1 : %2 tâches ; le job %3 assemble ce qu’elles dessinent</translation>
    </message>
    <message>
        <source>Prints a job template of the Open Job Description.</source>
        <translation>Affiche un modèle de job d’Open Job Description.</translation>
    </message>
    <message>
        <source>Prints a job type of Flamenco 3 for its folder of scripts.</source>
        <translation>Affiche un type de job de Flamenco 3, pour son dossier de scripts.</translation>
    </message>
    <message>
        <source>%1: the plan is damaged, or of another version; make it anew</source>
        <translation>%1 : le plan est endommagé, ou d’une autre version ; refaites-le</translation>
    </message>
    <message>
        <source>the plan is damaged; make it anew</source>
        <translation>le plan est endommagé ; refaites-le</translation>
    </message>
    <message>
        <source>%1: there is another plan already. Remove the folder, or choose another one.</source>
        <translation>%1 : il y a déjà un autre plan. Supprimez le dossier, ou choisissez-en un autre.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made. Choose another one, or change its permissions.</source>
        <translation>%1 : impossible de créer le dossier. Choisissez-en un autre, ou modifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>%1: there is something else already. Remove it, or choose another name.</source>
        <translation>%1 : il y a déjà autre chose. Supprimez-le, ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: there is no plan (%2). Is the shared folder there? farm plan makes one.</source>
        <translation>%1 : il n’y a pas de plan (%2). Le dossier partagé est-il là ? farm plan en fait un.</translation>
    </message>
    <message>
        <source>%1: the folder is gone. Is the shared folder there?</source>
        <translation>%1 : le dossier a disparu. Le dossier partagé est-il là ?</translation>
    </message>
    <message>
        <source>The folder of the farm, which all machines share.</source>
        <translation>Le dossier de la ferme, que toutes les machines partagent.</translation>
    </message>
    <message>
        <source>Frames of the paintings being painted: name%05d.png; of several, %s is the painting&apos;s name.</source>
        <translation>Images des tableaux en train de se peindre : name%05d.png ; s’il y en a plusieurs, %s est le nom du tableau.</translation>
    </message>
    <message>
        <source>Tiles of a Deep Zoom: jpg or png.</source>
        <translation>Tuiles d’un Deep Zoom : jpg ou png.</translation>
    </message>
    <message>
        <source>8 or 16 bits (default 8).</source>
        <translation>8 ou 16 bits (par défaut 8).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100.</source>
        <translation>Pour JPEG et WebP, de 1 à 100.</translation>
    </message>
    <message>
        <source>a farm draws numbered frames, name%05d.png</source>
        <translation>une ferme dessine des images numérotées, name%05d.png</translation>
    </message>
    <message>
        <source>Plans the drawing of paintings by many machines.</source>
        <translation>Planifie le dessin de tableaux par plusieurs machines.</translation>
    </message>
    <message>
        <source>-o FOLDER is missing: name the folder that all machines share</source>
        <translation>-o FOLDER manque : nommez le dossier que toutes les machines partagent</translation>
    </message>
    <message>
        <source>give --tiles or --frames</source>
        <translation>indiquez --tiles ou --frames</translation>
    </message>
    <message>
        <source>several paintings need several names: put %s where the painting&apos;s name is to stand, as in out/%s.dzi</source>
        <translation>plusieurs tableaux demandent plusieurs noms : mettez %s là où doit figurer le nom du tableau, comme dans out/%s.dzi</translation>
    </message>
    <message>
        <source>%1: two paintings would become the same file. Rename one.</source>
        <translation>%1 : deux tableaux deviendraient le même fichier. Renommez-en un.</translation>
    </message>
    <message>
        <source>--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8</source>
        <translation>--task %1 : indiquez i/n, p. ex. 3/8, de 1/8 à 8/8</translation>
    </message>
    <message>
        <source>the plan is for %1 &quot;%2&quot;, and this machine has &quot;%3&quot;, which makes other bits. Use the same program on all machines, or make a new plan</source>
        <translation>le plan est fait pour %1 « %2 », et cette machine a « %3 », qui produit d’autres bits. Utilisez le même programme sur toutes les machines, ou faites un nouveau plan</translation>
    </message>
    <message>
        <source>%1: the painting has changed since it was planned. Bring it back, or make a new plan.</source>
        <translation>%1 : le tableau a changé depuis sa planification. Remettez-le, ou faites un nouveau plan.</translation>
    </message>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start the task again.</source>
        <translation>%1 Ce que dessine un autre moteur a d’autres bits, et n’y est pas mêlé. Relancez la tâche.</translation>
    </message>
    <message>
        <source>Draws what is missing of a task; as often as is liked.</source>
        <translation>Dessine ce qui manque d’une tâche ; aussi souvent que l’on veut.</translation>
    </message>
    <message>
        <source>Which part: i/n, from 1/n to n/n (default 1/1).</source>
        <translation>Quelle partie : i/n, de 1/n à n/n (par défaut 1/1).</translation>
    </message>
    <message>
        <source>stopped; what is finished is kept, and the same command goes on</source>
        <translation>arrêté ; ce qui est terminé est gardé, et la même commande continue</translation>
    </message>
    <message>
        <source>task %1: %2 drawn, %3 there already</source>
        <translation>tâche %1 : %2 dessinés, %3 déjà là</translation>
    </message>
    <message>
        <source>let many machines draw pictures in tiles, and films</source>
        <translation>faire dessiner à plusieurs machines des images en tuiles, et des films</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a smaller --size, --scale or --area</source>
        <translation>une image de %1 × %2 pixels est trop grande : au plus %3 par côté. Réduisez --size, --scale ou --area</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1 : est un dossier. Donnez un nom de fichier.</translation>
    </message>
    <message>
        <source>A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a folder; --format jpg or png.</source>
        <translation>Une image de n’importe quelle taille en tuiles : OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) ou un dossier ; --format jpg ou png.</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side (default 254; TIFF 512).</source>
        <translation>Avec --tiles : pixels par côté (par défaut 254 ; TIFF 512).</translation>
    </message>
    <message>
        <source>With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0).</source>
        <translation>Avec --tiles : pixels que les tuiles montrent de leurs voisines (par défaut 1 ; TIFF 0).</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192).</source>
        <translation>Avec --tiles : pixels par côté de ce qui est dessiné à la fois (par défaut 2048 ; CUDA 8192).</translation>
    </message>
    <message>
        <source>--%1 is not for --tiles</source>
        <translation>--%1 ne va pas avec --tiles</translation>
    </message>
    <message>
        <source>--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder</source>
        <translation>--tiles %1 : le nom manque : indiquez wall.dzi, wall.tif ou un dossier</translation>
    </message>
    <message>
        <source>--tiles %1: give a name that ends in .dzi or .tif, or a folder</source>
        <translation>--tiles %1 : donnez un nom qui se termine par .dzi ou .tif, ou un dossier</translation>
    </message>
    <message>
        <source>--format is for Deep Zoom: the tiles of a TIFF are packed in it</source>
        <translation>--format concerne Deep Zoom : les tuiles d’un TIFF y sont intégrées</translation>
    </message>
    <message>
        <source>--format %1: tiles of a Deep Zoom are jpg or png</source>
        <translation>--format %1 : les tuiles d’un Deep Zoom sont en jpg ou png</translation>
    </message>
    <message>
        <source>--depth %1: tiles have 8 or 16 bits</source>
        <translation>--depth %1 : les tuiles ont 8 ou 16 bits</translation>
    </message>
    <message>
        <source>tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif</source>
        <translation>les tuiles JPEG ont 8 bits et pas de transparence : utilisez --format png, ou .tif</translation>
    </message>
    <message>
        <source>tiles of a TIFF do not overlap, and have sides of a multiple of 16</source>
        <translation>les tuiles d’un TIFF ne se chevauchent pas, et leurs côtés sont des multiples de 16</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1 : %2 morceaux de %n tableau</numerusform>
            <numerusform>%1 : %2 morceaux de %n tableaux</numerusform>
        </translation>
    </message>
    <message>
        <source>these are more than %1 pieces. Choose a greater --sheet, a smaller picture, or several plans.</source>
        <translation>cela fait plus de %1 morceaux. Choisissez un --sheet plus grand, une image plus petite, ou plusieurs plans.</translation>
    </message>
    <message>
        <source>other machines cannot read this standard input: give files</source>
        <translation>les autres machines ne peuvent pas lire cette entrée standard : indiquez des fichiers</translation>
    </message>
    <message>
        <source>auto (default: a GPU where there is one), cpu or cuda.</source>
        <translation>auto (par défaut : un GPU s’il y en a un), cpu ou cuda.</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu or cuda</source>
        <translation>--backend %1 : indiquez auto, cpu ou cuda</translation>
    </message>
    <message>
        <source>the GPU failed (%1); the CPU went on</source>
        <translation>le GPU a échoué (%1) ; le CPU a continué</translation>
    </message>
    <message>
        <source>stopped before it came nearer than %1; nothing was written</source>
        <translation>arrêté avant de s’approcher à plus de %1 ; rien n’a été écrit</translation>
    </message>
    <message>
        <source>--error %1 was not reached: it is %2. Give more --strokes or --iterations.</source>
        <translation>--error %1 n’a pas été atteint : c’est %2. Augmentez --strokes ou --iterations.</translation>
    </message>
    <message>
        <source>%1: is damaged</source>
        <translation>%1 : est endommagé</translation>
    </message>
    <message>
        <source>%1: is missing</source>
        <translation>%1 : est manquant</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>%n autre fichier manque ou est endommagé ; farm verify --json les nomme tous.</numerusform>
            <numerusform>%n autres fichiers manquent ou sont endommagés ; farm verify --json les nomme tous.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1 : %n ligne de ce journal est endommagée, on ne sait donc pas ce qui était terminé. Relancez les tâches : elles dessinent ce qui manque.</numerusform>
            <numerusform>%1 : %n lignes de ce journal sont endommagées, on ne sait donc pas ce qui était terminé. Relancez les tâches : elles dessinent ce qui manque.</numerusform>
        </translation>
    </message>
    <message>
        <source>the new strokes are farther from %1 than those before: %2 of 255, and before it was %3. Give more --strokes or --iterations.</source>
        <translation>les nouveaux traits sont plus loin de %1 que les précédents : %2 sur 255, contre %3 avant. Augmentez --strokes ou --iterations.</translation>
    </message>
    <message>
        <source>%1 cannot be used</source>
        <translation>%1 n’est pas utilisable</translation>
    </message>
    <message>
        <source>Lists the extensions that there are.</source>
        <translation>Énumère les extensions présentes.</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1 : lecture impossible</translation>
    </message>
    <message>
        <source>%1: there is no such extension. See suffuse-cli extension list.</source>
        <translation>%1 : cette extension n’existe pas. Voir suffuse-cli extension list.</translation>
    </message>
    <message>
        <source>--set %1: give FIELD=VALUE with one of the fields %2</source>
        <translation>--set %1 : indiquez FIELD=VALUE avec l’un des champs %2</translation>
    </message>
    <message>
        <source>%1; give it by --set</source>
        <translation>%1 ; indiquez-le avec --set</translation>
    </message>
    <message>
        <source>Runs an extension on a painting, and writes what it makes of it.</source>
        <translation>Exécute une extension sur un tableau, et écrit ce qu’elle en fait.</translation>
    </message>
    <message>
        <source>A field&apos;s value; may be given several times.</source>
        <translation>La valeur d’un champ ; peut être indiquée plusieurs fois.</translation>
    </message>
    <message>
        <source>The strokes that are selected, by their ids, such as 3,7,20-180.</source>
        <translation>Les traits sélectionnés, par leurs identifiants, comme 3,7,20-180.</translation>
    </message>
    <message>
        <source>The group that is painted on, by its name.</source>
        <translation>Le groupe dans lequel on peint, par son nom.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the file to write</source>
        <translation>-o OUT manque : nommez le fichier à écrire</translation>
    </message>
    <message>
        <source>%1 makes no painting; leave -o away</source>
        <translation>%1 ne produit pas de tableau ; omettez -o</translation>
    </message>
    <message>
        <source>%1: end the name with .suffuse or .json</source>
        <translation>%1 : terminez le nom par .suffuse ou .json</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli extension COMMAND [options] …</source>
        <translation>Usage : suffuse-cli extension COMMANDE [options] …</translation>
    </message>
    <message>
        <source>the extensions that there are, with their fields</source>
        <translation>les extensions présentes, avec leurs champs</translation>
    </message>
    <message>
        <source>run one on a painting, and write what it makes of it</source>
        <translation>en exécuter une sur un tableau, et écrire ce qu’elle en fait</translation>
    </message>
    <message>
        <source>extension %1: there is no such command. See suffuse-cli extension --help.</source>
        <translation>extension %1 : cette commande n’existe pas. Voir suffuse-cli extension --help.</translation>
    </message>
    <message>
        <source>run programs of others on a painting</source>
        <translation>exécuter les programmes d’autres auteurs sur un tableau</translation>
    </message>
    <message>
        <source>Its id, as extension list names it, or the path of its folder.</source>
        <translation>Son identifiant, tel qu’extension list le nomme, ou le chemin de son dossier.</translation>
    </message>
    <message>
        <source>%1: it belongs to the farm in %2, and two farms would overwrite each other&apos;s pieces. Choose another name, or, if that farm is not wanted any more, remove its folder.</source>
        <translation>%1 : appartient à la ferme dans %2, et deux fermes s’écraseraient leurs morceaux. Choisissez un autre nom ou, si cette ferme n’est plus voulue, supprimez son dossier.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is another farm being planned?</source>
        <translation>%1 : écriture impossible (%2). Une autre ferme est-elle en cours de planification ?</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Presse-papiers</translation>
    </message>
    <message>
        <source>There are no paths in the SVG of the clipboard.</source>
        <translation>Le SVG du presse-papiers ne contient aucun chemin.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>%Ln trait ne peut pas se trouver là, trop loin, et a été omis.</numerusform>
            <numerusform>%Ln traits ne peuvent pas se trouver là, trop loin, et ont été omis.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>En SVG, pour d’autres programmes, ce qui a été effacé en douceur est omis : %n effacement.</numerusform>
            <numerusform>En SVG, pour d’autres programmes, ce qui a été effacé en douceur est omis : %n effacements.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG n’a pas de groupes qui masquent, effacent ou écrêtent ce qui est dessous : %n groupe est devenu ordinaire.</numerusform>
            <numerusform>SVG n’a pas de groupes qui masquent, effacent ou écrêtent ce qui est dessous : %n groupes sont devenus ordinaires.</numerusform>
        </translation>
    </message>
    <message>
        <source>An erasure is not copied without the paint that it takes away. Duplicate doubles it within its stroke, Delete removes it.</source>
        <translation>Un effacement ne se copie pas sans la peinture qu’il enlève. Dupliquer le double dans son trait, Supprimer l’enlève.</translation>
    </message>
    <message>
        <source>What was pasted lies outside of what is seen of the canvas. View ▸ Zoom to Selection goes there.</source>
        <translation>Ce qui a été collé se trouve hors de la partie visible du canevas. Affichage ▸ Zoomer sur la sélection y va.</translation>
    </message>
    <message>
        <source>There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.</source>
        <translation>Là, on ne le verrait pas : ce qui a été collé se trouve au milieu de la partie visible du canevas.</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG n’a pas de lavis : les traits de %n groupe s’y superposent.</numerusform>
            <numerusform>SVG n’a pas de lavis : les traits de %n groupes s’y superposent.</numerusform>
        </translation>
    </message>
    <message>
        <source>The clipboard holds no strokes, no SVG paths, no picture and no colour.</source>
        <translation>Le presse-papiers ne contient ni traits, ni chemins SVG, ni image, ni couleur.</translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>En SVG, pour d’autres programmes, les images sont omises : %n.</numerusform>
            <numerusform>En SVG, pour d’autres programmes, les images sont omises : %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>What came was painted after the moment that you look at. It was brought back to this moment, so that you see it.</source>
        <translation>L’élément ajouté a été peint après le moment que vous regardez. Il a été ramené à ce moment pour que vous le voyiez.</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Delete segments</source>
        <translation>Supprimer les segments</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln segment supprimé ; Annuler le restaure.</numerusform>
            <numerusform>%Ln segments supprimés ; Annuler les restaure.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1 : %Ln trait ; Annuler revient en arrière.</numerusform>
            <numerusform>%1 : %Ln traits ; Annuler revient en arrière.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln trait supprimé ; Annuler le restaure.</numerusform>
            <numerusform>%Ln traits supprimés ; Annuler les restaure.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Supprimer les traits</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>The erasure is there twice now, and takes twice: drag the copy, or move it with the arrow keys.</source>
        <translation>L’effacement est maintenant là deux fois et enlève deux fois : faites glisser la copie, ou déplacez-la avec les touches fléchées.</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Raise to top</source>
        <translation>Monter au premier plan</translation>
    </message>
    <message>
        <source>Lower to bottom</source>
        <translation>Descendre à l’arrière-plan</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>Retourner horizontalement</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>Retourner verticalement</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>Tourner de 90°</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Distribuer</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grouper</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Dégrouper</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Verrouiller les traits</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Masquer les traits</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Tout déverrouiller</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Rename strokes</source>
        <translation>Renommer les traits</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Renommer le groupe</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplifier</translation>
    </message>
    <message>
        <source>Smooth strokes</source>
        <translation>Lisser les traits</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Grow or shrink paint</source>
        <translation>Élargir ou rétrécir la peinture</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>La sélection est verrouillée ou masquée.</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>Rien ne change.</translation>
    </message>
    <message>
        <source>Apply brush</source>
        <translation>Appliquer le pinceau</translation>
    </message>
    <message>
        <source>Apply form of the brush</source>
        <translation>Appliquer la forme du pinceau</translation>
    </message>
    <message>
        <source>Apply colour of the brush</source>
        <translation>Appliquer la couleur du pinceau</translation>
    </message>
    <message>
        <source>Apply texture of the brush</source>
        <translation>Appliquer la texture du pinceau</translation>
    </message>
    <message>
        <source>No appearance was copied.</source>
        <translation>Aucun aspect n’a été copié.</translation>
    </message>
    <message>
        <source>Paste appearance</source>
        <translation>Coller l’aspect</translation>
    </message>
    <message>
        <source>Combine strokes</source>
        <translation>Combiner les traits</translation>
    </message>
    <message>
        <source>Break apart</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Remove erasures</source>
        <translation>Supprimer les effacements</translation>
    </message>
    <message>
        <source>Recolour artwork</source>
        <translation>Redéfinir les couleurs</translation>
    </message>
    <message>
        <source>The painting has no swatches yet.</source>
        <translation>Le tableau n’a pas encore de nuances.</translation>
    </message>
    <message>
        <source>Map colours to swatches</source>
        <translation>Associer les couleurs aux nuances</translation>
    </message>
    <message>
        <source>Not combined: one stroke has one fill, and these differ, overlap, or are missing in some strokes.</source>
        <translation>Non combiné : un trait a un seul remplissage, et ceux-ci diffèrent, se chevauchent ou manquent dans certains traits.</translation>
    </message>
    <message>
        <source>Aligning takes two strokes or groups that are not locked. A group counts as one; it can be aligned relative to the canvas.</source>
        <translation>Pour aligner, il faut deux traits ou groupes non verrouillés. Un groupe compte pour un ; on peut l’aligner par rapport au canevas.</translation>
    </message>
    <message>
        <source>Distributing takes three strokes or groups that are not locked. A group counts as one.</source>
        <translation>Pour distribuer, il faut trois traits ou groupes non verrouillés. Un groupe compte pour un.</translation>
    </message>
    <message>
        <source>Clip group to what lies below</source>
        <translation>Écrêter le groupe par ce qui est dessous</translation>
    </message>
    <message>
        <source>Clip group no more</source>
        <translation>Ne plus écrêter le groupe</translation>
    </message>
    <message>
        <source>Use group as mask</source>
        <translation>Utiliser le groupe comme masque</translation>
    </message>
    <message>
        <source>Use group as mask no more</source>
        <translation>Ne plus utiliser le groupe comme masque</translation>
    </message>
    <message>
        <source>Make group a wash</source>
        <translation>Faire du groupe un lavis</translation>
    </message>
    <message>
        <source>Make wash a plain group</source>
        <translation>Faire du lavis un groupe ordinaire</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Supprimer le calque</translation>
    </message>
    <message>
        <source>Make group a draft</source>
        <translation>Faire du groupe une ébauche</translation>
    </message>
    <message>
        <source>Export draft again</source>
        <translation>Exporter à nouveau l’ébauche</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>%Ln trait maintenant. Là où leur peinture se rencontre, elle se mélange et ne s’additionne plus.</numerusform>
            <numerusform>%Ln traits maintenant. Là où leur peinture se rencontre, elle se mélange et ne s’additionne plus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln trait sélectionné. Supprimer une seconde fois le supprime.</numerusform>
            <numerusform>%Ln traits sélectionnés. Supprimer une seconde fois les supprime.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln segment sélectionné. Supprimer une seconde fois le supprime.</numerusform>
            <numerusform>%Ln segments sélectionnés. Supprimer une seconde fois les supprime.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>The selected strokes were exported last, and nothing is selected. Select strokes, or choose Export…</source>
        <translation>Les traits sélectionnés ont été exportés la dernière fois, et rien n’est sélectionné. Sélectionnez des traits, ou choisissez Exporter…</translation>
    </message>
    <message>
        <source>There is nothing to export. Choose Export…</source>
        <translation>Il n’y a rien à exporter. Choisissez Exporter…</translation>
    </message>
</context>
<context>
    <name>FigureWarnings</name>
    <message>
        <source>Widest at %1 s; from then on it grows narrower while it spreads.</source>
        <translation>Le plus large à %1 s ; ensuite, il se rétrécit en s’étalant.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. Up to %1 is clear.</source>
        <translation>ξ2 trop grand pour ξ1 : le trait n’a pas de bord net et teinte aussi loin que va sa peinture. Net jusqu’à %1.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the paint inside the dark rim vanishes.</source>
        <translation>ξ2 trop grand pour ξ1 : la peinture à l’intérieur du bord sombre disparaît.</translation>
    </message>
    <message>
        <source>Density 0: there is no paint.</source>
        <translation>Densité 0 : il n’y a pas de peinture.</translation>
    </message>
    <message>
        <source>Opacity 0 %: nothing of it is seen.</source>
        <translation>Opacité 0 % : on n’en voit rien.</translation>
    </message>
    <message>
        <source>Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.</source>
        <extracomment>%1: seconds after it was painted</extracomment>
        <translation>Disparaît à %1 s : ensuite, on n’en voit rien. Plus de φ, ou moins de D ou de temps de séchage, le conserve.</translation>
    </message>
    <message>
        <source>Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.</source>
        <translation>Des parties disparaissent, la première à %1 s. Plus de φ, ou moins de D ou de temps de séchage, les conserve.</translation>
    </message>
    <message>
        <source>Strength 0: nothing is taken away.</source>
        <translation>Intensité 0 : rien n’est enlevé.</translation>
    </message>
</context>
<context>
    <name>FileReplacement</name>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1 : écriture impossible (%2). Choisissez un autre dossier, ou modifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>%1: the disk is full (%2). Free some space, or choose another disk.</source>
        <translation>%1 : le disque est plein (%2). Libérez de l’espace, ou choisissez un autre disque.</translation>
    </message>
    <message>
        <source>%1: writing failed (%2). Choose another place.</source>
        <translation>%1 : l’écriture a échoué (%2). Choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1 : est un dossier. Donnez un nom de fichier.</translation>
    </message>
    <message>
        <source>%1: is not a plain file. Choose another name.</source>
        <translation>%1 : n’est pas un fichier ordinaire. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: the folder %2 does not exist. Create it, or choose another.</source>
        <translation>%1 : le dossier %2 n’existe pas. Créez-le, ou choisissez-en un autre.</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>a film has %1 to %2 frames a second</source>
        <translation>un film a de %1 à %2 images par seconde</translation>
    </message>
    <message>
        <source>MP4 cannot hold transparency. Use WebM, WebP or frames.</source>
        <translation>MP4 ne prend pas en charge la transparence. Utilisez WebM, WebP ou des images.</translation>
    </message>
    <message>
        <source>a video has at most %1 pixels a side</source>
        <translation>une vidéo a au plus %1 pixels par côté</translation>
    </message>
    <message>
        <source>%1: cannot write into this folder. Choose another one.</source>
        <translation>%1 : écriture impossible dans ce dossier. Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>frames are numbered files: give a name such as film/%05d.png, or one that ends in .webp, .webm or .mp4</source>
        <translation>les images sont des fichiers numérotés : donnez un nom comme film/%05d.png, ou qui se termine par .webp, .webm ou .mp4</translation>
    </message>
    <message>
        <source>%1: ffmpeg, which makes videos, is not installed. Install it, or choose WebP or frames.</source>
        <translation>%1 : ffmpeg, qui fait les vidéos, n’est pas installé. Installez-le, ou choisissez WebP ou des images.</translation>
    </message>
    <message>
        <source>%1: ffmpeg could not make the video (%2). Choose another format or size.</source>
        <translation>%1 : ffmpeg n’a pas pu faire la vidéo (%2). Choisissez un autre format ou une autre taille.</translation>
    </message>
    <message>
        <source>%1: the film could not be written (%2).</source>
        <translation>%1 : le film n’a pas pu être écrit (%2).</translation>
    </message>
    <message>
        <source>%1: the film is too large for WebP. Choose another format, a smaller size or fewer frames.</source>
        <translation>%1 : le film est trop grand pour WebP. Choisissez un autre format, une taille plus petite ou moins d’images.</translation>
    </message>
</context>
<context>
    <name>ImageFormat</name>
    <message>
        <source>This is no image format that can be written. Use one of these endings: %1.</source>
        <translation>Ce format d’image ne peut pas être écrit. Utilisez l’une de ces extensions : %1.</translation>
    </message>
    <message>
        <source>%1 cannot hold depth %2. Choose %3, or another format.</source>
        <translation>%1 ne prend pas en charge la profondeur %2. Choisissez %3, ou un autre format.</translation>
    </message>
    <message>
        <source>%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.</source>
        <translation>%1 ne prend pas en charge la transparence. Utilisez PNG, TIFF, EXR ou WebP, ou exportez avec l’arrière-plan.</translation>
    </message>
    <message>
        <source>%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.</source>
        <translation>%1 contient de 1 à %2 pixels par côté, pas %3 × %4. Choisissez une autre taille ou un autre format.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large: at most %3 million pixels can be drawn. Choose a smaller size.</source>
        <translation>Une image de %1 × %2 pixels est trop grande : %3 millions de pixels au plus peuvent être dessinés. Choisissez une taille plus petite.</translation>
    </message>
    <message>
        <source>%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.</source>
        <translation>%1 ne peut pas contenir de profil de couleur. Utilisez PNG, TIFF, JPEG ou WebP, ou exportez en sRGB.</translation>
    </message>
</context>
<context>
    <name>ImageModule</name>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>ne peut pas être chargé (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>est d’une autre version de Suffuse</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again, with what suffuse-cli recommends. Pictures ending in .pfm work without it</source>
        <translation>un composant de Suffuse, %1, %2 ; réinstallez Suffuse, avec ce que suffuse-cli recommande. Les images en .pfm fonctionnent sans lui</translation>
    </message>
</context>
<context>
    <name>ImageReader</name>
    <message>
        <source>%1: the image declares more than %2 × %2 or %3 million pixels. Scale it down first.</source>
        <translation>%1 : l’image annonce plus de %2 × %2 ou de %3 millions de pixels. Réduisez-la d’abord.</translation>
    </message>
    <message>
        <source>%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.</source>
        <translation>%1 : n’est pas une image PNG, JPEG, TIFF, EXR ou WebP. Convertissez-la d’abord.</translation>
    </message>
    <message>
        <source>%1: cannot read %2: %3.</source>
        <translation>%1 : impossible de lire %2 : %3.</translation>
    </message>
    <message>
        <source>%1: the %2 image cannot be read (%3). It may be damaged, or too large (at most %4 pixels a side, %5 million in all).</source>
        <translation>%1 : impossible de lire l’image %2 (%3). Elle est peut-être endommagée, ou trop grande (au plus %4 pixels par côté, %5 millions en tout).</translation>
    </message>
</context>
<context>
    <name>ImageWriter</name>
    <message>
        <source>%1: cannot write %2: %3.</source>
        <translation>%1 : impossible d’écrire %2 : %3.</translation>
    </message>
    <message>
        <source>%1: writing was cancelled; nothing was changed.</source>
        <translation>%1 : l’écriture a été annulée ; rien n’a changé.</translation>
    </message>
    <message>
        <source>%1: %2 could not be written (%3). Choose another format or depth.</source>
        <translation>%1 : impossible d’écrire %2 (%3). Choisissez un autre format ou une autre profondeur.</translation>
    </message>
    <message>
        <source>%1: the colour profile cannot be used: %2. Choose another one.</source>
        <translation>%1 : le profil de couleur n’est pas utilisable : %2. Choisissez-en un autre.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>there are no strokes in it</source>
        <translation>il ne contient aucun trait</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>Importer des traits</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Return</source>
        <extracomment>the key, as it is called on keyboards</extracomment>
        <translation>Entrée</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Save the changes to “%1” before closing?</source>
        <translation>Enregistrer les modifications de « %1 » avant de fermer ?</translation>
    </message>
    <message>
        <source>Suffuse did not come up the last times, so it has started with the usual settings. Yours are kept in %1.</source>
        <translation>Suffuse n’a pas pu s’ouvrir les dernières fois ; il a donc démarré avec les réglages par défaut. Les vôtres sont conservés dans %1.</translation>
    </message>
    <message>
        <source>Leave out the quotation marks: file dialogs take them for the borders between several names.</source>
        <translation>Omettez les guillemets : les boîtes de dialogue de fichiers y voient la séparation entre plusieurs noms.</translation>
    </message>
    <message>
        <source>“%1” is only an ending. Give a name before it.</source>
        <translation>« %1 » n’est qu’une extension. Mettez un nom devant.</translation>
    </message>
    <message>
        <source>Nothing is lost: the painting stays open as it is.</source>
        <translation>Rien n’est perdu : le tableau reste ouvert tel quel.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>Un autre programme a modifié « %1 ».</translation>
    </message>
    <message>
        <source>The file stays as it is until you save.</source>
        <translation>Le fichier reste tel quel jusqu’à ce que vous enregistriez.</translation>
    </message>
    <message>
        <source>Overwriting gives up what the other program wrote.</source>
        <translation>Écraser le fichier fait perdre ce que l’autre programme a écrit.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>É&amp;craser</translation>
    </message>
    <message>
        <source>&amp;Keep Mine</source>
        <translation>&amp;Garder le mien</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Recharger</translation>
    </message>
    <message>
        <source>Reloading takes away what was painted since the last save; Undo brings it back.</source>
        <translation>Recharger efface ce qui a été peint depuis le dernier enregistrement ; Annuler le restaure.</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>« %1 » existe. Le remplacer ?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Without saving, what has not been saved yet is lost.</source>
        <translation>Sans enregistrer, ce qui n’a pas encore été enregistré est perdu.</translation>
    </message>
</context>
<context>
    <name>NodeDrag</name>
    <message>
        <source>Move nodes</source>
        <translation>Déplacer les nœuds</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Déplacer le nœud</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>Déplacer la poignée</translation>
    </message>
    <message>
        <source>Bend curve</source>
        <translation>Courber</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Déplacer l’effacement</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>paper image</source>
        <translation>image de papier</translation>
    </message>
    <message>
        <source>paper image: there is none. Choose an image, or another kind of paper.</source>
        <translation>image de papier : il n’y en a pas. Choisissez une image, ou un autre type de papier.</translation>
    </message>
</context>
<context>
    <name>Papers</name>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Cold press</source>
        <translation>Grain fin</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Grain torchon</translation>
    </message>
    <message>
        <source>Rice</source>
        <translation>Riz</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>Impossible de lire %1 : %2.</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MB: choose a smaller picture.</source>
        <translation>%1 dépasse 64 Mo : choisissez une image plus petite.</translation>
    </message>
</context>
<context>
    <name>ReferenceRenderer</name>
    <message>
        <source>%1 threads · double</source>
        <translation>%1 threads · double</translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n thread</numerusform>
            <numerusform>%n threads</numerusform>
        </translation>
    </message>
    <message>
        <source>The CUDA backend cannot run: %1. Use the CPU backend.</source>
        <translation>Le moteur CUDA ne peut pas fonctionner : %1. Utilisez le moteur CPU.</translation>
    </message>
    <message>
        <source>%1 stopped: %2. The CPU draws now.</source>
        <translation>%1 s’est arrêté : %2. Le CPU dessine maintenant.</translation>
    </message>
    <message>
        <source>the picture is too large</source>
        <translation>l’image est trop grande</translation>
    </message>
    <message>
        <source>this program was built without the CUDA renderer</source>
        <translation>ce programme a été compilé sans le rendu CUDA</translation>
    </message>
    <message>
        <source>no NVIDIA driver, or one that is too old for this program</source>
        <translation>pas de pilote NVIDIA, ou trop ancien pour ce programme</translation>
    </message>
    <message>
        <source>there is no NVIDIA GPU</source>
        <translation>il n’y a pas de GPU NVIDIA</translation>
    </message>
    <message>
        <source>the NVIDIA driver does not work</source>
        <translation>le pilote NVIDIA ne fonctionne pas</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>mémoire insuffisante pour %1 × %2 pixels. Choisissez une taille plus petite.</translation>
    </message>
    <message>
        <source>The reference finds no gradients. Use the CPU backend.</source>
        <translation>La référence ne calcule pas de gradients. Utilisez le moteur CPU.</translation>
    </message>
</context>
<context>
    <name>Retiming</name>
    <message>
        <source>Ease in time</source>
        <translation>Changer le rythme</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Déplacer dans le temps</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>Étirer dans le temps</translation>
    </message>
    <message>
        <source>%1, with its erasures</source>
        <translation>%1, avec ses effacements</translation>
    </message>
    <message>
        <source>%1; erasures keep their time</source>
        <translation>%1 ; les effacements gardent leur temps</translation>
    </message>
    <message>
        <source>Later by %1 s</source>
        <translation>Plus tard de %1 s</translation>
    </message>
    <message>
        <source>Drawn in %1 s</source>
        <translation>Dessiné en %1 s</translation>
    </message>
    <message>
        <source>Begins at %1 % of its pace</source>
        <translation>Commence à %1 % de son rythme</translation>
    </message>
    <message>
        <source>Ends at %1 % of its pace</source>
        <translation>Finit à %1 % de son rythme</translation>
    </message>
</context>
<context>
    <name>SelectHints</name>
    <message>
        <source>Drag: scale. Ctrl: keep the proportions. Shift: about the centre.</source>
        <translation>Glisser : mettre à l’échelle. Ctrl : garder les proportions. Maj : depuis le centre.</translation>
    </message>
    <message>
        <source>Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.</source>
        <translation>Glisser : tourner. Ctrl : par pas de 15°. Maj : autour du coin opposé.</translation>
    </message>
    <message>
        <source>Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.</source>
        <translation>Glisser : incliner. Ctrl : par pas de 15°. Maj : par rapport au côté opposé.</translation>
    </message>
    <message>
        <source>Drag: move the centre of rotation. Shift+click: back into the middle.</source>
        <translation>Glisser : déplacer le centre de rotation. Maj+clic : le ramener au milieu.</translation>
    </message>
    <message>
        <source>Shift+Alt+click: add the next stroke below, with Ctrl within its group. Shift+Alt+drag: add what the path touches.</source>
        <translation>Maj+Alt+clic : ajouter le trait suivant en dessous ; avec Ctrl, dans son groupe. Maj+Alt+glisser : ce que le trajet touche.</translation>
    </message>
    <message>
        <source>Alt+click: select the next stroke below, with Ctrl within its group. Alt+drag: select what the path touches.</source>
        <translation>Alt+clic : sélectionner le trait suivant en dessous ; avec Ctrl, dans son groupe. Alt+glisser : ce que le trajet touche.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.</source>
        <translation>Ctrl+Maj+clic : ajouter ou retirer un trait d’un groupe. Ctrl+Maj+glisser : retirer.</translation>
    </message>
    <message>
        <source>Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.</source>
        <translation>Ctrl+clic : un trait d’un groupe. Ctrl+glisser : déplacer le long d’un axe.</translation>
    </message>
    <message>
        <source>Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.</source>
        <translation>Maj+clic : ajouter ou retirer. Maj+glisser : ajouter ce que le cadre entoure ; en déplaçant : ne pas aimanter.</translation>
    </message>
    <message>
        <source>Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke below.</source>
        <translation>Clic sur la peinture : sélectionner le trait. Glisser : cadre ; sur la peinture, avec Maj. Alt+clic : trait du dessous.</translation>
    </message>
    <message>
        <source>Move by %1, %2</source>
        <translation>Déplacer de %1, %2</translation>
    </message>
    <message>
        <source>Scale to %1 % × %2 %</source>
        <translation>Mettre à l’échelle à %1 % × %2 %</translation>
    </message>
    <message>
        <source>Rotate by %1</source>
        <translation>Tourner de %1</translation>
    </message>
    <message>
        <source>Skew by %1°</source>
        <translation>Incliner de %1°</translation>
    </message>
    <message>
        <source>Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one below.</source>
        <translation>Glisser : déplacer. Recliquer : tourner et incliner. Double-clic : valeurs. Maj+clic : ajouter. Alt+clic : celui du dessous.</translation>
    </message>
</context>
<context>
    <name>SvgPaths</name>
    <message>
        <source>SVG, line %1: %2</source>
        <translation>SVG, ligne %1 : %2</translation>
    </message>
</context>
<context>
    <name>TimelinePicture</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Each stroke is a bar here: from when it is painted until it is dry.</source>
        <translation>Ici, chaque trait est une barre : du moment où il est peint jusqu’à ce qu’il soit sec.</translation>
    </message>
</context>
<context>
    <name>Underlay</name>
    <message>
        <source>%1: there is not enough memory for it.</source>
        <translation>%1 : mémoire insuffisante.</translation>
    </message>
</context>
<context>
    <name>UnderlayCommands</name>
    <message>
        <source>Import underlay</source>
        <translation>Importer un modèle</translation>
    </message>
    <message>
        <source>Replace underlay</source>
        <translation>Remplacer le modèle</translation>
    </message>
    <message>
        <source>Show underlay</source>
        <translation>Afficher le modèle</translation>
    </message>
    <message>
        <source>Hide underlay</source>
        <translation>Masquer le modèle</translation>
    </message>
    <message>
        <source>Change underlay opacity</source>
        <translation>Changer l’opacité du modèle</translation>
    </message>
    <message>
        <source>Move underlay</source>
        <translation>Déplacer le modèle</translation>
    </message>
    <message>
        <source>Resize underlay</source>
        <translation>Redimensionner le modèle</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Fit underlay to the canvas</source>
        <translation>Ajuster le modèle au canevas</translation>
    </message>
    <message>
        <source>Remove underlay</source>
        <translation>Supprimer le modèle</translation>
    </message>
</context>
<context>
    <name>Validate</name>
    <message>
        <source>it is earlier than the one before it; put them in order of time</source>
        <translation>c’est plus tôt que le précédent ; mettez-les dans l’ordre du temps</translation>
    </message>
    <message>
        <source>another group has the same id</source>
        <translation>un autre groupe a le même identifiant</translation>
    </message>
    <message>
        <source>there is no group with this id</source>
        <translation>aucun groupe n’a cet identifiant</translation>
    </message>
    <message>
        <source>the group would lie within itself</source>
        <translation>le groupe serait contenu dans lui-même</translation>
    </message>
    <message>
        <source>the group&apos;s members do not stand together in the order</source>
        <translation>les membres du groupe ne se suivent pas dans l’ordre</translation>
    </message>
    <message>
        <source>there is no such style</source>
        <translation>ce style n’existe pas</translation>
    </message>
    <message>
        <source>only edge darkening has a third value</source>
        <translation>seul le style à bords sombres a une troisième valeur</translation>
    </message>
    <message>
        <source>there is no such mixing mode</source>
        <translation>ce mode de mélange n’existe pas</translation>
    </message>
    <message>
        <source>only beta mixing has a beta</source>
        <translation>seul le mélange bêta a un bêta</translation>
    </message>
    <message>
        <source>there is no such kind of node</source>
        <translation>ce type de nœud n’existe pas</translation>
    </message>
    <message>
        <source>a stroke needs at least one</source>
        <translation>un trait en demande au moins un</translation>
    </message>
    <message>
        <source>a segment that lifts cannot fade as well</source>
        <translation>un segment qui éponge ne peut pas aussi atténuer</translation>
    </message>
    <message>
        <source>the segment does not start where the one before it ends</source>
        <translation>le segment ne commence pas où finit le précédent</translation>
    </message>
    <message>
        <source>there is no such kind of paper</source>
        <translation>ce type de papier n’existe pas</translation>
    </message>
    <message>
        <source>the paper&apos;s image is missing</source>
        <translation>l’image du papier manque</translation>
    </message>
    <message>
        <source>the stroke is missing</source>
        <translation>le trait manque</translation>
    </message>
    <message>
        <source>another stroke has the same id</source>
        <translation>un autre trait a le même identifiant</translation>
    </message>
    <message>
        <source>%1: %2 is not in %3</source>
        <translation>%1 : %2 n’est pas dans %3</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>ce type n’existe pas</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input</source>
        <translation>une autre courbe a la même grandeur et la même entrée</translation>
    </message>
    <message>
        <source>it needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>il faut de 2 à 16 points [x, y] dans [0, 1], de gauche à droite</translation>
    </message>
    <message>
        <source>there is no such rule</source>
        <translation>cette règle n’existe pas</translation>
    </message>
    <message>
        <source>it is the same point as from; a gradient needs two</source>
        <translation>c’est le même point que « from » ; un dégradé en demande deux</translation>
    </message>
    <message>
        <source>there is no such grain of paper</source>
        <translation>ce grain de papier n’existe pas</translation>
    </message>
    <message>
        <source>style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2</source>
        <translation>style.xi[1] : %1 dépasse 2^(1/3) fois xi[0], qui est %2</translation>
    </message>
    <message>
        <source>there is no such alignment</source>
        <translation>cet alignement n’existe pas</translation>
    </message>
    <message>
        <source>it is no valid Unicode</source>
        <translation>ce n’est pas de l’Unicode valide</translation>
    </message>
    <message>
        <source>%1: %2 characters are more than %3</source>
        <translation>%1 : %2 caractères, c’est plus que %3</translation>
    </message>
    <message>
        <source>%1: %2 curves are more than %3</source>
        <translation>%1 : %2 courbes, c’est plus que %3</translation>
    </message>
    <message>
        <source>there is no such blend mode</source>
        <translation>ce mode de fusion n’existe pas</translation>
    </message>
    <message>
        <source>there is no such colour to mark groups</source>
        <translation>cette couleur pour marquer les groupes n’existe pas</translation>
    </message>
    <message>
        <source>it needs an image, or a link with the SHA-256 of its file</source>
        <translation>il faut une image, ou un lien avec le SHA-256 de son fichier</translation>
    </message>
    <message>
        <source>it is no path of a file</source>
        <translation>ce n’est pas un chemin de fichier</translation>
    </message>
    <message>
        <source>it has more than 67 million pixels</source>
        <translation>elle a plus de 67 millions de pixels</translation>
    </message>
    <message>
        <source>its corners lie on one line; a picture needs an area</source>
        <translation>ses coins sont sur une même ligne ; une image demande une surface</translation>
    </message>
</context>
<context>
    <name>WidthHandle</name>
    <message>
        <source>Drag to set the width by the density, Shift: by the diffusion.</source>
        <translation>Glisser pour régler la largeur par la densité, Maj : par la diffusion.</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Changer la largeur</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.</source>
        <translation>Les images n’ont pas la même taille (%1 × %2 et %3 × %4) : faites le rendu des deux à une même taille.</translation>
    </message>
</context>
<context>
    <name>suffuse::AboutDialog</name>
    <message>
        <source>About Suffuse</source>
        <translation>À propos de Suffuse</translation>
    </message>
    <message>
        <source>Icon of Suffuse</source>
        <translation>Icône de Suffuse</translation>
    </message>
    <message>
        <source>Suffuse %1</source>
        <translation>Suffuse %1</translation>
    </message>
    <message>
        <source>Paints with strokes that really diffuse, and stay editable.</source>
        <translation>Peint avec des traits qui diffusent vraiment, et restent modifiables.</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0.</source>
        <translation>Logiciel libre sous licence Apache 2.0.</translation>
    </message>
</context>
<context>
    <name>suffuse::AgePlot</name>
    <message>
        <source>No paint here</source>
        <translation>Pas de peinture ici</translation>
    </message>
    <message>
        <source>density φ, up to %1</source>
        <translation>densité φ, jusqu’à %1</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>âge %1 s</translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message>
        <source>Along the Stroke</source>
        <translation>Le long du trait</translation>
    </message>
    <message>
        <source>Curve along the stroke</source>
        <translation>Courbe le long du trait</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>The same value all along</source>
        <translation>La même valeur tout du long</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Evenly from one value to another</source>
        <translation>Régulièrement d’une valeur à une autre</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Dessinée</translation>
    </message>
    <message>
        <source>A curve drawn with the pointer</source>
        <translation>Une courbe dessinée avec le pointeur</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Change along the stroke</source>
        <translation>Changer le long du trait</translation>
    </message>
    <message>
        <source>Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve is drawn with the pointer. The dots are the values of the segments.</source>
        <translation>Tirez la ligne, ses extrémités ou ses points ; un appui à côté crée un point, Suppr en supprime un. Une courbe dessinée se trace avec le pointeur. Les pastilles sont les valeurs des segments.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>The values that there are, as a curve of points that can be moved</source>
        <translation>Les valeurs présentes, comme une courbe de points que l’on peut déplacer</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Multiplier</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Multiplies all of it; what varies along the stroke stays</source>
        <translation>Multiplie l’ensemble ; ce qui varie le long du trait est conservé</translation>
    </message>
    <message>
        <source>Is added to all of it; what varies along the stroke stays</source>
        <translation>S’ajoute à l’ensemble ; ce qui varie le long du trait est conservé</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trait %1</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n trait</numerusform>
            <numerusform>%n traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke – %1</source>
        <translation>Le long du trait – %1</translation>
    </message>
    <message>
        <source>Nothing is selected that can be changed. Click a stroke, and its values are shown here.</source>
        <translation>Rien de modifiable n’est sélectionné. Cliquez sur un trait, et ses valeurs s’affichent ici.</translation>
    </message>
</context>
<context>
    <name>suffuse::AreaRow</name>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Which part of the canvas is drawn</source>
        <translation>Quelle partie du canevas est dessinée</translation>
    </message>
    <message>
        <source>Whole canvas</source>
        <translation>Canevas entier</translation>
    </message>
    <message>
        <source>What is painted</source>
        <translation>Ce qui est peint</translation>
    </message>
    <message>
        <source>Selected strokes</source>
        <translation>Traits sélectionnés</translation>
    </message>
    <message>
        <source>What the window shows</source>
        <translation>Ce que montre la fenêtre</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>Par nombres</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Bord gauche</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>Bord supérieur</translation>
    </message>
    <message>
        <source>W</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantRow</name>
    <message>
        <source>Parallel Lines</source>
        <translation>Lignes parallèles</translation>
    </message>
    <message>
        <source>Vanishing Point</source>
        <translation>Point de fuite</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Concentric Ellipses</source>
        <translation>Ellipses concentriques</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>What is made next</source>
        <translation>Ce qui est créé ensuite</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Horizontal place of the chosen point, canvas units</source>
        <translation>Position horizontale du point choisi, en unités de canevas</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Vertical place of the chosen point, canvas units</source>
        <translation>Position verticale du point choisi, en unités de canevas</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Angle of the line or of the first half axis, clockwise</source>
        <translation>Angle de la ligne ou du premier demi-axe, dans le sens horaire</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>First half axis of the ellipse, canvas units</source>
        <translation>Premier demi-axe de l’ellipse, en unités de canevas</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Second half axis of the ellipse, canvas units</source>
        <translation>Second demi-axe de l’ellipse, en unités de canevas</translation>
    </message>
    <message>
        <source>A new one in the middle of the view</source>
        <translation>Un nouveau au milieu de la vue</translation>
    </message>
    <message>
        <source>New assistant</source>
        <translation>Nouvel assistant</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantTool</name>
    <message>
        <source>Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next point. Return: a new one.</source>
        <translation>Glisser : nouvel assistant ; glisser ses points ou lignes le modifie. Maj : par pas. Tab : point suivant. Entrée : un nouveau.</translation>
    </message>
    <message>
        <source>%1, point %2 of %3: x %4, y %5</source>
        <extracomment>%1: an assistant, as &quot;Vanishing Point&quot;</extracomment>
        <translation>%1, point %2 sur %3 : x %4, y %5</translation>
    </message>
</context>
<context>
    <name>suffuse::AttributeBrushTool</name>
    <message>
        <source>How fast it is laid down</source>
        <translation>À quelle vitesse la valeur est déposée</translation>
    </message>
    <message>
        <source>Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.</source>
        <translation>Glisser sur les traits pour peindre la valeur choisie sur leurs segments. [ et ] changent la taille.</translation>
    </message>
    <message>
        <source>Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.</source>
        <translation>Glisser sur la sélection pour peindre la valeur choisie sur ses segments. [ et ] changent la taille.</translation>
    </message>
    <message>
        <source>Paint diffusion</source>
        <translation>Peindre la diffusion</translation>
    </message>
    <message>
        <source>Paint density</source>
        <translation>Peindre la densité</translation>
    </message>
    <message>
        <source>Paint granulation</source>
        <translation>Peindre la granulation</translation>
    </message>
    <message>
        <source>Paint colour</source>
        <translation>Peindre la couleur</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>Peindre l’opacité</translation>
    </message>
    <message>
        <source>Paint drying time</source>
        <translation>Peindre le temps de séchage</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it is.</source>
        <translation>Un remplissage a sa propre densité, ρ, que montre l’inspecteur. On peut la peindre relativement à ce qu’elle est.</translation>
    </message>
</context>
<context>
    <name>suffuse::BackupsDialog</name>
    <message>
        <source>Restore Backup</source>
        <translation>Restaurer une sauvegarde</translation>
    </message>
    <message>
        <source>There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings says how many are.</source>
        <translation>Il n’y a pas encore de sauvegarde de « %1 ». Au prochain enregistrement, la version précédente est conservée ; les Réglages disent combien le sont.</translation>
    </message>
    <message>
        <source>An earlier version of “%1” takes the place of the painting as it is now. Undo brings that back, and no file changes until you save.</source>
        <translation>Une version antérieure de « %1 » prend la place du tableau actuel. Annuler restaure celui-ci, et aucun fichier ne change tant que vous n’enregistrez pas.</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>Sauvegardes, la plus récente d’abord</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Restaurer</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>illisible</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushColourPage</name>
    <message>
        <source>Second colour</source>
        <translation>Seconde couleur</translation>
    </message>
    <message>
        <source>&amp;Take the Current Colour</source>
        <translation>&amp;Prendre la couleur actuelle</translation>
    </message>
    <message>
        <source>Makes the current colour the second one</source>
        <translation>Fait de la couleur actuelle la seconde</translation>
    </message>
    <message>
        <source>The row Second colour of the curves says when it comes through.</source>
        <translation>La ligne Seconde couleur des courbes dit quand elle apparaît.</translation>
    </message>
    <message>
        <source>Strays from the colour by</source>
        <translation>Écart de couleur</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>At most so much redder or less red</source>
        <translation>Jusqu’à autant de rouge en plus ou en moins</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>At most so much more or less yellow</source>
        <translation>Jusqu’à autant de jaune en plus ou en moins</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>At most so much bluer or less blue</source>
        <translation>Jusqu’à autant de bleu en plus ou en moins</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Clarté</translation>
    </message>
    <message>
        <source>At most so much lighter or darker</source>
        <translation>Jusqu’à autant de clarté en plus ou en moins</translation>
    </message>
    <message>
        <source>Drifts along the stroke</source>
        <translation>Dérive le long du trait</translation>
    </message>
    <message>
        <source>Else each stroke has one colour</source>
        <translation>Sinon, chaque trait a une seule couleur</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCombo</name>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Rechercher des pinceaux</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCurvesPage</name>
    <message>
        <source>Second colour</source>
        <translation>Seconde couleur</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>By stroke</source>
        <translation>Par trait</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>What changes with what: a tick switches a curve on, a click shows it below</source>
        <translation>Ce qui change avec quoi : une coche active une courbe, un clic l’affiche en dessous</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Drag points; click for another one, drag it out to take it away</source>
        <translation>Tirer les points ; cliquer pour en ajouter un, le tirer dehors pour le retirer</translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation>Vitesse max.</translation>
    </message>
    <message>
        <source>Speed at the right end of its curves, in sizes a second</source>
        <translation>Vitesse à l’extrémité droite de ses courbes, en tailles par seconde</translation>
    </message>
    <message>
        <source> sizes/s</source>
        <translation> tailles/s</translation>
    </message>
    <message>
        <source>Full distance</source>
        <translation>Distance max.</translation>
    </message>
    <message>
        <source>Distance at the right end of its curves, in sizes</source>
        <translation>Distance à l’extrémité droite de ses courbes, en tailles</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> tailles</translation>
    </message>
    <message>
        <source>Way on which what drifts becomes another, in sizes</source>
        <translation>Distance sur laquelle ce qui dérive change de valeur, en tailles</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushDialog</name>
    <message>
        <source>A stroke of the brush</source>
        <translation>Un trait du pinceau</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peinture</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Shape and hand</source>
        <translation>Forme et geste</translation>
    </message>
    <message>
        <source>Settings of the brush</source>
        <translation>Réglages du pinceau</translation>
    </message>
    <message>
        <source>Keeps the changes in the brush of this name; built-in brushes stay as they are</source>
        <translation>Conserve les modifications dans le pinceau de ce nom ; les pinceaux intégrés restent tels quels</translation>
    </message>
    <message>
        <source>Keeps the brush under another name</source>
        <translation>Conserve le pinceau sous un autre nom</translation>
    </message>
    <message>
        <source>Closes this window; the brush stays in hand as it is</source>
        <translation>Ferme cette fenêtre ; le pinceau reste en main tel quel</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pinceau : %1</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushGrid</name>
    <message>
        <source>Brushes</source>
        <translation>Pinceaux</translation>
    </message>
    <message>
        <source>%1: size %2, dry after %3</source>
        <translation>%1 : taille %2, sec après %3</translation>
    </message>
    <message>
        <source>Changed since the program was started; Reload in its menu undoes that</source>
        <translation>Modifié depuis le lancement du programme ; Recharger dans son menu annule cela</translation>
    </message>
    <message>
        <source>There is no such brush.</source>
        <translation>Ce pinceau n’existe pas.</translation>
    </message>
    <message>
        <source>Choose a brush to paint with it.</source>
        <translation>Choisissez un pinceau pour peindre avec.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushHandPage</name>
    <message>
        <source>Tip</source>
        <translation>Pointe</translation>
    </message>
    <message>
        <source>Of the tip, against the path or the canvas</source>
        <translation>De la pointe, par rapport au trajet ou au canevas</translation>
    </message>
    <message>
        <source>Turns with the path</source>
        <translation>Tourne avec le trajet</translation>
    </message>
    <message>
        <source>Else it keeps its angle on the canvas, as a broad nib does</source>
        <translation>Sinon, elle garde son angle sur le canevas, comme une plume large</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> tailles</translation>
    </message>
    <message>
        <source>Taper in</source>
        <translation>Effilement initial</translation>
    </message>
    <message>
        <source>Length on which the stroke grows from its tip</source>
        <translation>Longueur sur laquelle le trait grandit depuis sa pointe</translation>
    </message>
    <message>
        <source>Taper out</source>
        <translation>Effilement final</translation>
    </message>
    <message>
        <source>Length on which it runs out when the pen lifts</source>
        <translation>Longueur sur laquelle il s’éteint quand le stylet se lève</translation>
    </message>
    <message>
        <source>Tip size</source>
        <translation>Taille de pointe</translation>
    </message>
    <message>
        <source>Size at the very end</source>
        <translation>Taille à la toute extrémité</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Geste</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Stabilise la main : le trait suit le stylet en douceur, ou est tiré par un fil</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Time between the points that the curve is fitted through</source>
        <translation>Temps entre les points par lesquels passe la courbe ajustée</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushLibrary</name>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; check its permissions</source>
        <translation>%1 : impossible de créer le dossier ; vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; save it under a name of its own</source>
        <translation>%1 est un pinceau intégré ; enregistrez-le sous un autre nom</translation>
    </message>
    <message>
        <source>A brush needs a name</source>
        <translation>Un pinceau a besoin d’un nom</translation>
    </message>
    <message>
        <source>There is a brush “%1” already</source>
        <translation>Il y a déjà un pinceau « %1 »</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; it stays</source>
        <translation>%1 est un pinceau intégré ; on ne peut pas le supprimer</translation>
    </message>
    <message>
        <source>%1 could not be removed; check its permissions</source>
        <translation>Impossible de supprimer %1 ; vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>There is no brush “%1”</source>
        <translation>Il n’y a pas de pinceau « %1 »</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushMenu</name>
    <message>
        <source>&amp;Edit Brush…</source>
        <translation>&amp;Modifier le pinceau…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favori</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>&amp;Enregistrer les modifications</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>Re&amp;nommer…</translation>
    </message>
    <message>
        <source>De&amp;lete…</source>
        <translation>S&amp;upprimer…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Save Brush</source>
        <translation>Enregistrer le pinceau</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Rename Brush</source>
        <translation>Renommer le pinceau</translation>
    </message>
    <message>
        <source>Delete the brush “%1”?</source>
        <translation>Supprimer le pinceau « %1 » ?</translation>
    </message>
    <message>
        <source>Strokes painted with it stay.</source>
        <translation>Les traits peints avec lui restent.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Import Brushes</source>
        <translation>Importer des pinceaux</translation>
    </message>
    <message>
        <source>Brushes (*.suffuse-brush *.myb);;All files (*)</source>
        <translation>Pinceaux (*.suffuse-brush *.myb);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1: these settings have no counterpart here: %2</source>
        <translation>%1 : ces réglages n’ont pas d’équivalent ici : %2</translation>
    </message>
    <message>
        <source>Export Brush</source>
        <translation>Exporter le pinceau</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Pinceau Suffuse</translation>
    </message>
    <message>
        <source>Rel&amp;oad</source>
        <translation>Re&amp;charger</translation>
    </message>
    <message>
        <source>&amp;Apply to Selection</source>
        <translation>&amp;Appliquer à la sélection</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>Pinceau en&amp;tier</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>F&amp;orme seulement</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>Couleur seu&amp;lement</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>Textu&amp;re seulement</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPaintPage</name>
    <message>
        <source>Style</source>
        <translation>Style</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Comment la densité devient couverture.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Comment la peinture se mélange à ce qui est dessous : elle couvre, ou les pigments s’additionnent.</translation>
    </message>
    <message>
        <source>How long the paint spreads; the size stays</source>
        <translation>Combien de temps la peinture s’étale ; la taille ne change pas</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPalette</name>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the painting is shown</source>
        <translation>À quelle échelle le tableau est affiché</translation>
    </message>
    <message>
        <source>Brush palette</source>
        <translation>Palette de pinceaux</translation>
    </message>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Choisissez avec quoi peindre. La couleur ne change pas.</translation>
    </message>
    <message>
        <source>Current colour</source>
        <translation>Couleur actuelle</translation>
    </message>
    <message>
        <source>Near colours</source>
        <translation>Couleurs proches</translation>
    </message>
    <message>
        <source>Lighter and darker, the neighbouring hues, and from grey to full</source>
        <translation>Plus clair et plus foncé, les teintes voisines, et du gris au saturé</translation>
    </message>
    <message>
        <source>Painted with last</source>
        <translation>Derniers utilisés</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Couleurs récentes</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPanel</name>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Choisissez avec quoi peindre. La couleur ne change pas.</translation>
    </message>
    <message>
        <source>Reset brush</source>
        <translation>Réinitialiser le pinceau</translation>
    </message>
    <message>
        <source>Back to the brush as it came</source>
        <translation>Revenir au pinceau d’origine</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (modifié)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Rechercher des pinceaux</translation>
    </message>
    <message>
        <source>Shows brushes and groups with this in their name</source>
        <translation>Montre les pinceaux et groupes dont le nom contient ce texte</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>Favoris seulement</translation>
    </message>
    <message>
        <source>Show favourites only; the first nine have the keys 1 to 9</source>
        <translation>N’afficher que les favoris ; les neuf premiers ont les touches 1 à 9</translation>
    </message>
    <message>
        <source>Brush menu</source>
        <translation>Menu des pinceaux</translation>
    </message>
    <message>
        <source>Edit, save, import and export brushes</source>
        <translation>Modifier, enregistrer, importer et exporter des pinceaux</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushTool</name>
    <message>
        <source>Brush stroke</source>
        <translation>Trait de pinceau</translation>
    </message>
    <message>
        <source>Shift+drag to go on with the selected stroke from its end.</source>
        <translation>Maj+glisser pour continuer le trait sélectionné depuis son extrémité.</translation>
    </message>
    <message>
        <source>Extend stroke</source>
        <translation>Prolonger le trait</translation>
    </message>
    <message>
        <source>This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.</source>
        <translation>Ce trait se trouve hors du canevas : Affichage ▸ Afficher la peinture hors du canevas le montre.</translation>
    </message>
    <message>
        <source>All that you paint stays editable: press V and click paint to move, scale or recolour it.</source>
        <translation>Tout reste modifiable : touche V, puis clic sur la peinture pour la déplacer, la redimensionner ou la recolorer.</translation>
    </message>
    <message>
        <source>Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture&apos;s colour, with Shift the stroke&apos;s own.</source>
        <translation>Glisser : peindre ; toucher : un point. Bouton droit : palette. Maj : taille, opacité. Ctrl+clic : couleur de l’image ; avec Maj, celle du trait.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushToolOptions</name>
    <message>
        <source>Width of a dry line at full pressure, in units ([ and ] change it)</source>
        <translation>Largeur d’une ligne sèche à pleine pression, en unités ([ et ] la changent)</translation>
    </message>
    <message>
        <source>How much the paint covers ({ and } change it)</source>
        <translation>À quel point la peinture couvre ({ et } le changent)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Stabilise la main : le trait suit le stylet en douceur, ou est tiré par un fil</translation>
    </message>
    <message>
        <source>Amount of smoothing</source>
        <translation>Quantité de lissage</translation>
    </message>
    <message>
        <source>How strongly it lags behind, or how long the string is</source>
        <translation>Retard du trait sur le stylet, ou longueur du fil</translation>
    </message>
    <message>
        <source>Own brush</source>
        <translation>Pinceau personnel</translation>
    </message>
    <message>
        <source>What to paint with. Click: all brushes, with pictures.</source>
        <translation>Avec quoi peindre. Clic : tous les pinceaux, avec images.</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasDrops</name>
    <message>
        <source>Drop colour</source>
        <translation>Déposer la couleur</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasMenu</name>
    <message>
        <source>Under the Pointer</source>
        <translation>Sous le pointeur</translation>
    </message>
    <message>
        <source>Further Below</source>
        <translation>Plus bas</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>Dispo&amp;ser</translation>
    </message>
    <message>
        <source>R&amp;eshape</source>
        <translation>Remode&amp;ler</translation>
    </message>
    <message>
        <source>Dr&amp;ying</source>
        <translation>Séc&amp;hage</translation>
    </message>
    <message>
        <source>Brush and C&amp;olours</source>
        <translation>Pinceau et co&amp;uleurs</translation>
    </message>
    <message>
        <source>Apply &amp;Brush</source>
        <translation>Appliquer le &amp;pinceau</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aspect</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nœuds</translation>
    </message>
    <message>
        <source>Trans&amp;form</source>
        <translation>Trans&amp;former</translation>
    </message>
    <message>
        <source>Com&amp;bine and Break</source>
        <translation>Com&amp;biner et séparer</translation>
    </message>
    <message>
        <source>Select S&amp;ame</source>
        <translation>Sélectionner de &amp;même</translation>
    </message>
    <message>
        <source>Under&amp;lay</source>
        <translation>Mo&amp;dèle</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasSection</name>
    <message>
        <source>Canvas</source>
        <translation>Canevas</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Background colour. Click: white.</source>
        <translation>Couleur de l’arrière-plan. Clic : blanc.</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Changer l’arrière-plan</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Resize canvas</source>
        <translation>Redimensionner le canevas</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Largeur du canevas en unités ; une unité est un pixel à 100 %.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Hauteur du canevas en unités ; une unité est un pixel à 100 %.</translation>
    </message>
    <message>
        <source>%1 × %2 mm at %3 dpi</source>
        <translation>%1 × %2 mm à %3 ppp</translation>
    </message>
    <message>
        <source>%1 × %2 in at %3 dpi</source>
        <translation>%1 × %2 po à %3 ppp</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>The paper&apos;s grain, which granulating strokes show.</source>
        <translation>Le grain du papier, que montrent les traits granulants.</translation>
    </message>
    <message>
        <source>Take the grain from another picture file.</source>
        <translation>Prendre le grain d’un autre fichier image.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Another number gives another grain.</source>
        <translation>Un autre nombre donne un autre grain.</translation>
    </message>
    <message>
        <source>Change paper</source>
        <translation>Changer le papier</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Paper image</source>
        <translation>Image de papier</translation>
    </message>
    <message>
        <source>%1 cannot be used as paper: %2</source>
        <translation>%1 n’est pas utilisable comme papier : %2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Size of the coarsest grain or of a thread in units, or units per pixel of the image.</source>
        <translation>Taille du grain le plus grossier ou d’un fil en unités, ou unités par pixel de l’image.</translation>
    </message>
    <message>
        <source>Choose &amp;Image…</source>
        <translation>Choisir une &amp;image…</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasWidget</name>
    <message>
        <source>Canvas</source>
        <translation>Canevas</translation>
    </message>
    <message>
        <source>The picture goes to the screen by way of memory: %1</source>
        <translation>L’image arrive à l’écran par la mémoire : %1</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourChips</name>
    <message>
        <source>%1, opacity %2 %</source>
        <translation>%1, opacité %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourHeader</name>
    <message>
        <source>Shows and changes the colour that is painted with</source>
        <translation>Montre et change la couleur avec laquelle on peint</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>Couleur de la sélection</translation>
    </message>
    <message>
        <source>Shows and changes the colour of what is selected; it keeps its opacity</source>
        <translation>Montre et change la couleur de la sélection, sans changer son opacité</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>Several colours</source>
        <translation>Plusieurs couleurs</translation>
    </message>
    <message>
        <source>Set: all colours become the same.
Shift: all change as the shown one does, and keep their differences.</source>
        <translation>Fixer : toutes les couleurs deviennent identiques.
Décaler : toutes changent comme celle affichée, et gardent leurs différences.</translation>
    </message>
    <message>
        <source>Apply to selection</source>
        <translation>Appliquer à la sélection</translation>
    </message>
    <message>
        <source>Apply to selection: gives the selected segments the brush&apos;s colour. They keep their opacity.</source>
        <translation>Appliquer à la sélection : donne aux segments sélectionnés la couleur du pinceau, sans changer leur opacité.</translation>
    </message>
    <message>
        <source>Apply colour</source>
        <translation>Appliquer la couleur</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Couleur du pinceau</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPanel</name>
    <message>
        <source>Current colour</source>
        <translation>Couleur actuelle</translation>
    </message>
    <message>
        <source>The colour that is painted with</source>
        <translation>La couleur avec laquelle on peint</translation>
    </message>
    <message>
        <source>Previous colour</source>
        <translation>Couleur précédente</translation>
    </message>
    <message>
        <source>The colour painted with last. Click: back to it.</source>
        <translation>La couleur utilisée juste avant. Clic : y revenir.</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>Couleur sRGB sous forme #rrggbb, #rgb ou CSS : rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>« %1 » n’est pas une couleur. Écrivez-la sous forme #rrggbb, par exemple #2f6690.</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Couleurs récentes</translation>
    </message>
    <message>
        <source>Colours painted with before. Click: take it.</source>
        <translation>Couleurs utilisées auparavant. Clic : la prendre.</translation>
    </message>
    <message>
        <source>Colours painted with come here.</source>
        <translation>Les couleurs utilisées apparaissent ici.</translation>
    </message>
    <message>
        <source>RYB</source>
        <extracomment>red, yellow, blue; hue, saturation, value; red, green, blue</extracomment>
        <translation>RJB</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>TSV</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RVB</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>The numbers that the sliders show: paint as red, yellow and blue, or the screen&apos;s hue, saturation and value, or its red, green and blue</source>
        <translation>Les nombres que montrent les curseurs : la peinture en rouge, jaune et bleu, ou la teinte, la saturation et la valeur de l’écran, ou son rouge, son vert et son bleu</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Couleur du pinceau</translation>
    </message>
    <message>
        <source>The colour of the brush. Click: take it.</source>
        <translation>La couleur du pinceau. Clic : la prendre.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>plusieurs</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message>
        <source>Colour of the brush</source>
        <translation>Couleur du pinceau</translation>
    </message>
    <message>
        <source>Colour of a swatch</source>
        <translation>Couleur d’une nuance</translation>
    </message>
    <message>
        <source>Colour of the swatch “%1”</source>
        <translation>Couleur de la nuance « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>Couleurs de %Ln segment</numerusform>
            <numerusform>Couleurs de %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>Couleur de %Ln segment</numerusform>
            <numerusform>Couleur de %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>Couleurs de %Ln trait</numerusform>
            <numerusform>Couleurs de %Ln traits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>Couleur de %Ln trait</numerusform>
            <numerusform>Couleur de %Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Changer la couleur</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Change swatch</source>
        <translation>Changer la nuance</translation>
    </message>
    <message>
        <source>Colour of the fill</source>
        <translation>Couleur du remplissage</translation>
    </message>
    <message>
        <source>Colours of the fill</source>
        <translation>Couleurs du remplissage</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s end</source>
        <translation>Couleur de fin du dégradé</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s start</source>
        <translation>Couleur de début du dégradé</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>Roue des couleurs</translation>
    </message>
    <message>
        <source>Ring: hue in the order of pigments. Triangle: pure, white and black.
Arrow keys work too.</source>
        <translation>Anneau : teinte dans l’ordre des pigments. Triangle : pur, blanc et noir.
Les touches fléchées fonctionnent aussi.</translation>
    </message>
</context>
<context>
    <name>suffuse::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>Commands, brushes, docks, recent files</source>
        <translation>Commandes, pinceaux, panneaux, fichiers récents</translation>
    </message>
    <message>
        <source>Parts of names in any order; Enter runs the chosen one, Escape goes back.</source>
        <translation>Parties de noms dans n’importe quel ordre ; Entrée exécute la commande choisie, Échap revient en arrière.</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Click one to run it.</source>
        <translation>Cliquez sur un résultat pour l’exécuter.</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>Rien ne porte ce nom.</translation>
    </message>
    <message>
        <source>It cannot be used now.</source>
        <translation>Ne peut pas être utilisé maintenant.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>Ouvrir un fichier récent</translation>
    </message>
    <message>
        <source>“%1” cannot be used now.</source>
        <translation>« %1 » ne peut pas être utilisé maintenant.</translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Nouveau…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>&amp;Fermer la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Réta&amp;blir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Dupli&amp;quer</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>D&amp;eselect</source>
        <translation>D&amp;ésélectionner</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Settin&amp;gs…</source>
        <translation>Ré&amp;glages…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>Paint strokes</source>
        <translation>Peindre des traits</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Sélection</translation>
    </message>
    <message>
        <source>Select and move strokes</source>
        <translation>Sélectionner et déplacer des traits</translation>
    </message>
    <message>
        <source>Se&amp;gments</source>
        <translation>Se&amp;gments</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>Panorami&amp;que</translation>
    </message>
    <message>
        <source>Move the canvas</source>
        <translation>Déplacer le canevas</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>&amp;Lower</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>Raise to &amp;Top</source>
        <translation>Monter au pr&amp;emier plan</translation>
    </message>
    <message>
        <source>Lower to &amp;Bottom</source>
        <translation>Descendre à l’arrière-&amp;plan</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Zoom a&amp;vant</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit the Canvas</source>
        <translation>&amp;Ajuster le canevas</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>Tourner à &amp;gauche</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>Tourner à &amp;droite</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>Sans r&amp;otation</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>&amp;Miroir</translation>
    </message>
    <message>
        <source>&amp;Hide the Docks</source>
        <translation>Mas&amp;quer les panneaux</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Réinitiali&amp;ser la disposition</translation>
    </message>
    <message>
        <source>Docks and tool bars go back to where they stand at the first start</source>
        <translation>Panneaux et barres d’outils reprennent leur place du premier lancement</translation>
    </message>
    <message>
        <source>Full S&amp;creen</source>
        <translation>Plein &amp;écran</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>&amp;Raccourcis clavier…</translation>
    </message>
    <message>
        <source>&amp;About Suffuse…</source>
        <translation>À &amp;propos de Suffuse…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Ouvrir un fichier &amp;récent</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>Panneau&amp;x</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>O&amp;utils</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>Coller sur p&amp;lace</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Paste strokes where they were</source>
        <translation>Coller les traits là où ils étaient</translation>
    </message>
    <message>
        <source>Edit segments, nodes and handles of strokes</source>
        <translation>Modifier segments, nœuds et poignées des traits</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>&amp;Couteau</translation>
    </message>
    <message>
        <source>Cut strokes along a line</source>
        <translation>Couper des traits le long d’une ligne</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>Go&amp;mme</translation>
    </message>
    <message>
        <source>&amp;Attribute Brush</source>
        <translation>Pinceau d’a&amp;ttributs</translation>
    </message>
    <message>
        <source>Paint values onto segments</source>
        <translation>Peindre des valeurs sur des segments</translation>
    </message>
    <message>
        <source>Eye&amp;dropper</source>
        <translation>P&amp;ipette</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>Prélever une couleur</translation>
    </message>
    <message>
        <source>&amp;Insert Nodes</source>
        <translation>&amp;Insérer des nœuds</translation>
    </message>
    <message>
        <source>Insert a node into each selected segment</source>
        <translation>Insérer un nœud dans chaque segment sélectionné</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>Rendre &amp;anguleux</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Make the selected nodes corners</source>
        <translation>Rendre anguleux les nœuds sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Lisser</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Make the selected nodes smooth</source>
        <translation>Rendre lisses les nœuds sélectionnés</translation>
    </message>
    <message>
        <source>S&amp;ymmetric</source>
        <translation>Rendre &amp;symétrique</translation>
    </message>
    <message>
        <source>Shift+Y</source>
        <translation>Shift+Y</translation>
    </message>
    <message>
        <source>Make the selected nodes symmetric</source>
        <translation>Rendre symétriques les nœuds sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Break Strokes</source>
        <translation>&amp;Briser les traits</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Break strokes at the selected nodes</source>
        <translation>Briser les traits aux nœuds sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>&amp;Joindre les nœuds</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Join two selected end nodes</source>
        <translation>Joindre deux nœuds d’extrémité sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Delete Segments</source>
        <translation>Su&amp;pprimer les segments</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Brid&amp;ge Segments</source>
        <translation>&amp;Relier les segments</translation>
    </message>
    <message>
        <source>Alt+Del</source>
        <translation>Alt+Del</translation>
    </message>
    <message>
        <source>Replace selected segments by one that goes on smoothly</source>
        <translation>Remplacer les segments sélectionnés par un seul qui continue en douceur</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>In&amp;verser le sens</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>Let the selected strokes run from end to start</source>
        <translation>Faire aller les traits sélectionnés de la fin au début</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objet</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nœuds</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>&amp;Inverser la sélection</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>!</source>
        <translation>!</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Couleur</translation>
    </message>
    <message>
        <source>Select all strokes of the same colour</source>
        <translation>Sélectionner tous les traits de même couleur</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>&amp;Style</translation>
    </message>
    <message>
        <source>Select all strokes of the same style</source>
        <translation>Sélectionner tous les traits de même style</translation>
    </message>
    <message>
        <source>Select all strokes of the same brush</source>
        <translation>Sélectionner tous les traits de même pinceau</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Select what is drawn around; with Shift from paint, too</source>
        <translation>Sélectionner ce que l’on entoure ; avec Maj, en partant aussi de la peinture</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>&amp;Toucher</translation>
    </message>
    <message>
        <source>Select what a path touches</source>
        <translation>Sélectionner ce qu’un trajet touche</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Grouper</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>D&amp;égrouper</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>Verrou&amp;iller</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>&amp;Tout déverrouiller</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ma&amp;squer</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>T&amp;out afficher</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Re&amp;nommer…</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Flip Hori&amp;zontally</source>
        <translation>Retourner hori&amp;zontalement</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Retourner &amp;verticalement</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Rotate by &amp;90° Left</source>
        <translation>Tourner de &amp;90° à gauche</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate by 90° R&amp;ight</source>
        <translation>Tourner de 9&amp;0° à droite</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>&amp;Scale Spread with the Shape</source>
        <translation>Adapter l’étalement à la &amp;forme</translation>
    </message>
    <message>
        <source>Spread and density follow the shape when it is scaled</source>
        <translation>Étalement et densité suivent la forme mise à l’échelle</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>Bords &amp;gauches</translation>
    </message>
    <message>
        <source>&amp;Centres, Horizontally</source>
        <translation>&amp;Centres, horizontalement</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>Bords &amp;droits</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>Bords &amp;supérieurs</translation>
    </message>
    <message>
        <source>&amp;Middles, Vertically</source>
        <translation>&amp;Milieux, verticalement</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>Bords &amp;inférieurs</translation>
    </message>
    <message>
        <source>Relative to the &amp;Selection</source>
        <translation>Par rapport à la sé&amp;lection</translation>
    </message>
    <message>
        <source>Relative to the C&amp;anvas</source>
        <translation>Par rapport au canev&amp;as</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Horizontally</source>
        <translation>Écarts égaux, &amp;horizontalement</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Vertically</source>
        <translation>Écarts égaux, &amp;verticalement</translation>
    </message>
    <message>
        <source>Even &amp;Centres, Horizontally</source>
        <translation>&amp;Centres réguliers, horizontalement</translation>
    </message>
    <message>
        <source>Even C&amp;entres, Vertically</source>
        <translation>Centres ré&amp;guliers, verticalement</translation>
    </message>
    <message>
        <source>Snap to &amp;Nodes</source>
        <translation>Aimanter aux &amp;nœuds</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>Aimanter à la gr&amp;ille</translation>
    </message>
    <message>
        <source>&amp;Show the Grid</source>
        <translation>A&amp;fficher la grille</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Grid St&amp;ep…</source>
        <translation>&amp;Pas de la grille…</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>&amp;Aligner</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Distri&amp;buer</translation>
    </message>
    <message>
        <source>Select Sa&amp;me</source>
        <translation>Sélectionner de mê&amp;me</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Ti&amp;me</source>
        <translation>&amp;Temps</translation>
    </message>
    <message>
        <source>&amp;Favourite Brushes</source>
        <translation>Pinceaux fa&amp;voris</translation>
    </message>
    <message>
        <source>Favourite Brush %1</source>
        <translation>Pinceau favori %1</translation>
    </message>
    <message>
        <source>Relative to the &amp;First Selected</source>
        <translation>Par rapport au p&amp;remier sélectionné</translation>
    </message>
    <message>
        <source>Relative to the Bi&amp;ggest</source>
        <translation>Par rapport au &amp;plus grand</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play the painting being painted, or pause</source>
        <translation>Lire le tableau en train de se peindre, ou faire une pause</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>Aller au &amp;début</translation>
    </message>
    <message>
        <source>Shift+,</source>
        <translation>Shift+,</translation>
    </message>
    <message>
        <source>Go to where the painting begins</source>
        <translation>Aller là où le tableau commence</translation>
    </message>
    <message>
        <source>P&amp;revious Stroke</source>
        <translation>Trait &amp;précédent</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Go back to where a stroke begins</source>
        <translation>Revenir là où un trait commence</translation>
    </message>
    <message>
        <source>&amp;Next Stroke</source>
        <translation>Trait &amp;suivant</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Go on to where a stroke begins</source>
        <translation>Avancer là où un trait commence</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Aller à la &amp;fin</translation>
    </message>
    <message>
        <source>Shift+.</source>
        <translation>Shift+.</translation>
    </message>
    <message>
        <source>Go to the end, where all has dried: the present</source>
        <translation>Aller à la fin, quand tout est sec : le présent</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>En &amp;boucle</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>Lire encore et encore</translation>
    </message>
    <message>
        <source>S&amp;kip Pauses</source>
        <translation>Sa&amp;uter les pauses</translation>
    </message>
    <message>
        <source>Cut pauses in which nothing is painted or spreads to half a second</source>
        <translation>Réduire à une demi-seconde les pauses où rien n’est peint ni ne s’étale</translation>
    </message>
    <message>
        <source>Preview When &amp;Dry</source>
        <translation>&amp;Aperçu une fois sec</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Show wet paint as it will look when it has dried, while you paint too</source>
        <translation>Montrer la peinture humide telle qu’elle sera une fois sèche, même pendant que vous peignez</translation>
    </message>
    <message>
        <source>Let It Dr&amp;y</source>
        <translation>Laisser sé&amp;cher</translation>
    </message>
    <message>
        <source>Go to the moment at which all has dried</source>
        <translation>Aller au moment où tout est sec</translation>
    </message>
    <message>
        <source>&amp;Freeze Wet Paint</source>
        <translation>Fi&amp;ger la peinture humide</translation>
    </message>
    <message>
        <source>Ctrl+Alt+F</source>
        <translation>Ctrl+Alt+F</translation>
    </message>
    <message>
        <source>All that is wet stops spreading at this moment</source>
        <translation>Tout ce qui est humide cesse de s’étaler à ce moment</translation>
    </message>
    <message>
        <source>Re-&amp;wet…</source>
        <translation>Réhu&amp;midifier…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Let the selected paint spread on for a while from this moment</source>
        <translation>Laisser la peinture sélectionnée s’étaler encore un temps à partir de ce moment</translation>
    </message>
    <message>
        <source>Remove Re-we&amp;tting</source>
        <translation>Supprimer la &amp;réhumidification</translation>
    </message>
    <message>
        <source>The selected paint dries once and for all</source>
        <translation>La peinture sélectionnée sèche une fois pour toutes</translation>
    </message>
    <message>
        <source>&amp;Even</source>
        <translation>&amp;Régulier</translation>
    </message>
    <message>
        <source>Selected strokes are drawn at an even pace</source>
        <translation>Les traits sélectionnés se dessinent à un rythme régulier</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>Départ &amp;lent</translation>
    </message>
    <message>
        <source>Selected strokes begin slowly</source>
        <translation>Les traits sélectionnés commencent lentement</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>&amp;Arrivée lente</translation>
    </message>
    <message>
        <source>Selected strokes end slowly</source>
        <translation>Les traits sélectionnés finissent lentement</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Départ et arrivée le&amp;nts</translation>
    </message>
    <message>
        <source>Selected strokes begin and end slowly</source>
        <translation>Les traits sélectionnés commencent et finissent lentement</translation>
    </message>
    <message>
        <source>Export Ti&amp;melapse…</source>
        <translation>Exporter un acc&amp;éléré…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Make a film of the painting being painted</source>
        <translation>Faire un film du tableau en train de se peindre</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>Rythme du dessi&amp;n</translation>
    </message>
    <message>
        <source>Relative to the Last Select&amp;ed</source>
        <translation>Par rapport au dernier sélectio&amp;nné</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File</source>
        <translation>Garder l’&amp;historique d’annulation dans le fichier</translation>
    </message>
    <message>
        <source>Whoever opens the file can go on undoing. Take it out before you give a file away</source>
        <translation>Qui ouvre le fichier peut continuer à annuler. Retirez-le avant de transmettre un fichier</translation>
    </message>
    <message>
        <source>Import &amp;Underlay…</source>
        <translation>Importer un &amp;modèle…</translation>
    </message>
    <message>
        <source>A picture to paint over, which shows on the canvas only</source>
        <translation>Une image sur laquelle peindre, visible seulement sur le canevas</translation>
    </message>
    <message>
        <source>Show the Underl&amp;ay</source>
        <translation>Afficher le modè&amp;le</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>&amp;Import Strokes…</source>
        <translation>&amp;Importer des traits…</translation>
    </message>
    <message>
        <source>Drawings, recordings and the strokes of other paintings, into this one</source>
        <translation>Dessins, enregistrements et traits d’autres tableaux, dans celui-ci</translation>
    </message>
    <message>
        <source>S&amp;maller Tool Size</source>
        <translation>Outil plus p&amp;etit</translation>
    </message>
    <message>
        <source>La&amp;rger Tool Size</source>
        <translation>Outil plus gr&amp;and</translation>
    </message>
    <message>
        <source>&amp;Less Opacity</source>
        <translation>&amp;Baisser l’opacité</translation>
    </message>
    <message>
        <source>More &amp;Opacity</source>
        <translation>Augmenter l’opacit&amp;é</translation>
    </message>
    <message>
        <source>Move the Canvas While Held</source>
        <translation>Déplacer le canevas (maintenir)</translation>
    </message>
    <message>
        <source>Turn the Canvas While Held</source>
        <translation>Tourner le canevas (maintenir)</translation>
    </message>
    <message>
        <source>Move the Selection</source>
        <translation>Déplacer la sélection</translation>
    </message>
    <message>
        <source>Move the Selection Ten Times as Far</source>
        <translation>Déplacer la sélection dix fois plus loin</translation>
    </message>
    <message>
        <source>Move the Selection by One Unit</source>
        <translation>Déplacer la sélection d’une unité</translation>
    </message>
    <message>
        <source>Move the Selection by Ten Units</source>
        <translation>Déplacer la sélection de dix unités</translation>
    </message>
    <message>
        <source>Move Rows in the Strokes Dock</source>
        <translation>Déplacer les lignes du panneau Traits</translation>
    </message>
    <message>
        <source>Previous Stroke or Node</source>
        <translation>Trait ou nœud précédent</translation>
    </message>
    <message>
        <source>Give Up, or Deselect</source>
        <translation>Abandonner, ou désélectionner</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>Enregistrer une &amp;copie…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+S</source>
        <translation>Ctrl+Alt+Shift+S</translation>
    </message>
    <message>
        <source>Into another file; you go on painting in this one</source>
        <translation>Dans un autre fichier ; vous continuez à peindre dans celui-ci</translation>
    </message>
    <message>
        <source>Re&amp;vert…</source>
        <translation>Re&amp;venir au fichier…</translation>
    </message>
    <message>
        <source>Back to what the file holds; Undo takes it back</source>
        <translation>Revenir à ce que contient le fichier ; Annuler restaure l’état d’avant</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>Restaurer une sauve&amp;garde…</translation>
    </message>
    <message>
        <source>Back to an earlier version of the file</source>
        <translation>Revenir à une version antérieure du fichier</translation>
    </message>
    <message>
        <source>Export A&amp;gain</source>
        <translation>Exporter à no&amp;uveau</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>To the same file, with the same settings</source>
        <translation>Dans le même fichier, avec les mêmes réglages</translation>
    </message>
    <message>
        <source>Hide Outlines and Handles While Held</source>
        <translation>Masquer contours et poignées (maintenir)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Select all strokes of the same name</source>
        <translation>Sélectionner tous les traits de même nom</translation>
    </message>
    <message>
        <source>Select &amp;Found</source>
        <translation>Sélectionner les résultats de rec&amp;herche</translation>
    </message>
    <message>
        <source>Select what the search in the Strokes dock has found</source>
        <translation>Sélectionner ce que la recherche du panneau Traits a trouvé</translation>
    </message>
    <message>
        <source>Find Strokes</source>
        <translation>Rechercher des traits</translation>
    </message>
    <message>
        <source>Look for strokes and groups by their names, in the Strokes dock</source>
        <translation>Rechercher traits et groupes par leur nom, dans le panneau Traits</translation>
    </message>
    <message>
        <source>Show Ou&amp;tlines</source>
        <translation>Afficher les con&amp;tours</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Lines along the selected strokes; the Brush shows none</source>
        <translation>Lignes le long des traits sélectionnés ; le Pinceau n’en montre pas</translation>
    </message>
    <message>
        <source>Show Paint &amp;beyond the Canvas</source>
        <translation>Afficher la peinture &amp;hors du canevas</translation>
    </message>
    <message>
        <source>Under a veil, what was painted beside the canvas; it is in no picture that is exported</source>
        <translation>Sous un voile, ce qui a été peint à côté du canevas ; ce n’est dans aucune image exportée</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>Pann&amp;eau suivant</translation>
    </message>
    <message>
        <source>The keyboard goes from the canvas to the docks and tool bars in turn</source>
        <translation>Le clavier passe du canevas aux panneaux et barres d’outils, tour à tour</translation>
    </message>
    <message>
        <source>&amp;Previous Panel</source>
        <translation>Panneau pré&amp;cédent</translation>
    </message>
    <message>
        <source>The keyboard goes back from panel to panel</source>
        <translation>Le clavier revient de panneau en panneau</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler : %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>Réta&amp;blir : %1</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>Re&amp;chercher une commande…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Commands, brushes, docks and recent files by their names</source>
        <translation>Commandes, pinceaux, panneaux et fichiers récents par leur nom</translation>
    </message>
    <message>
        <source>Drawing pace</source>
        <translation>Rythme du dessin</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>Paus&amp;e</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Supprimer la réhumidification</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File (%1)</source>
        <translation>Garder l’&amp;historique d’annulation dans le fichier (%1)</translation>
    </message>
    <message>
        <source>Canvas, while held</source>
        <translation>Canevas, touche maintenue</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Canvas, Strokes dock</source>
        <translation>Canevas, panneau Traits</translation>
    </message>
    <message>
        <source>Canvas, Timeline dock</source>
        <translation>Canevas, panneau Chronologie</translation>
    </message>
    <message>
        <source>Canvas, Segments tool</source>
        <translation>Canevas, outil Segments</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canevas</translation>
    </message>
    <message>
        <source>Nothing is wet at this moment.</source>
        <translation>Rien n’est humide à ce moment.</translation>
    </message>
    <message>
        <source>Freeze wet paint</source>
        <translation>Figer la peinture humide</translation>
    </message>
    <message>
        <source>Nothing that is selected is painted yet at this moment.</source>
        <translation>Rien de ce qui est sélectionné n’est encore peint à ce moment.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Nom du groupe</translation>
    </message>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>Nom de %Ln trait</numerusform>
            <numerusform>Nom de %Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Re-wet</source>
        <translation>Réhumidifier</translation>
    </message>
    <message>
        <source>Seconds that the paint spreads on</source>
        <translation>Secondes pendant lesquelles la peinture s’étale encore</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Smooth the curves of the selected strokes; each time more</source>
        <translation>Lisser les courbes des traits sélectionnés ; davantage à chaque fois</translation>
    </message>
    <message>
        <source>S&amp;traighten</source>
        <translation>Re&amp;dresser</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Move the selected strokes towards straight lines; each time more</source>
        <translation>Rapprocher les traits sélectionnés de lignes droites ; davantage à chaque fois</translation>
    </message>
    <message>
        <source>&amp;Grow Paint</source>
        <translation>Élar&amp;gir la peinture</translation>
    </message>
    <message>
        <source>Ctrl+)</source>
        <translation>Ctrl+)</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes wider</source>
        <translation>Rendre plus large la peinture des traits sélectionnés</translation>
    </message>
    <message>
        <source>S&amp;hrink Paint</source>
        <translation>&amp;Rétrécir la peinture</translation>
    </message>
    <message>
        <source>Ctrl+(</source>
        <translation>Ctrl+(</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes narrower</source>
        <translation>Rendre plus étroite la peinture des traits sélectionnés</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>La sélection est verrouillée ou masquée.</translation>
    </message>
    <message>
        <source>Simp&amp;lify…</source>
        <translation>Sim&amp;plifier…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Make fewer segments of the selected strokes</source>
        <translation>Réduire le nombre de segments des traits sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Offset and More…</source>
        <translation>Dé&amp;caler et plus…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Offset, smooth, straighten, grow or shrink the selected strokes by numbers</source>
        <translation>Décaler, lisser, redresser, élargir ou rétrécir les traits sélectionnés avec des nombres</translation>
    </message>
    <message>
        <source>Resha&amp;pe</source>
        <translation>Remode&amp;ler</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Remplir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Wet what the selected strokes enclose; the inspector has its values</source>
        <translation>Mouiller ce que les traits sélectionnés entourent ; l’inspecteur en montre les valeurs</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Remove Fill</source>
        <translation>Supprimer le remplissage</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Supprimer le remplissage</translation>
    </message>
    <message>
        <source>Leave of the selected strokes their outlines</source>
        <translation>Ne laisser des traits sélectionnés que leurs contours</translation>
    </message>
    <message>
        <source>Geome&amp;tric Shapes</source>
        <translation>&amp;Formes géométriques</translation>
    </message>
    <message>
        <source>Paint rectangles, ellipses, polygons and stars</source>
        <translation>Peindre rectangles, ellipses, polygones et étoiles</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>Re&amp;dessiner</translation>
    </message>
    <message>
        <source>Draw over a part of a stroke, which follows the new line</source>
        <translation>Repasser une partie d’un trait, qui suit la nouvelle ligne</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>P&amp;ousser</translation>
    </message>
    <message>
        <source>Push, comb, pinch or roughen strokes</source>
        <translation>Pousser, peigner, pincer ou hérisser des traits</translation>
    </message>
    <message>
        <source>What lies under the pointer, and what can be done with it</source>
        <translation>Ce qui se trouve sous le pointeur, et ce que l’on peut en faire</translation>
    </message>
    <message>
        <source>Br&amp;ush Palette at the Pointer</source>
        <translation>Palette de pinceaux au pointeu&amp;r</translation>
    </message>
    <message>
        <source>Brushes, colours, size and zoom where the pointer is</source>
        <translation>Pinceaux, couleurs, taille et zoom à l’endroit du pointeur</translation>
    </message>
    <message>
        <source>Edit Value&amp;s Here…</source>
        <translation>Modifier les &amp;valeurs ici…</translation>
    </message>
    <message>
        <source>Width, diffusion, density, colour and opacity of what is selected, at the pointer</source>
        <translation>Largeur, diffusion, densité, couleur et opacité de la sélection, au pointeur</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>Pinceau &amp;entier</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Put the brush in hand on the selected strokes; they remember the pen&apos;s pressure</source>
        <translation>Appliquer le pinceau en main aux traits sélectionnés ; ils se souviennent de la pression du stylet</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>&amp;Forme seulement</translation>
    </message>
    <message>
        <source>Width, density, tapering and tip of the brush in hand</source>
        <translation>Largeur, densité, effilement et pointe du pinceau en main</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>&amp;Couleur seulement</translation>
    </message>
    <message>
        <source>Colour and opacity of the brush in hand</source>
        <translation>Couleur et opacité du pinceau en main</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>&amp;Texture seulement</translation>
    </message>
    <message>
        <source>Style, mixing, grain and drying time of the brush in hand</source>
        <translation>Style, mélange, grain et temps de séchage du pinceau en main</translation>
    </message>
    <message>
        <source>C&amp;opy Appearance</source>
        <translation>Copier l’as&amp;pect</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy style, mixing, values and colour of the stroke that was selected last</source>
        <translation>Copier style, mélange, valeurs et couleur du dernier trait sélectionné</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Put it on the selected strokes; what varies along them goes on varying</source>
        <translation>L’appliquer aux traits sélectionnés ; ce qui varie sur leur longueur continue de varier</translation>
    </message>
    <message>
        <source>Paste Appearance Evenl&amp;y</source>
        <translation>Coller l’aspect uni&amp;formément</translation>
    </message>
    <message>
        <source>Put it on the selected strokes, with the same values all along</source>
        <translation>L’appliquer aux traits sélectionnés, avec les mêmes valeurs tout du long</translation>
    </message>
    <message>
        <source>Along th&amp;e Stroke…</source>
        <translation>Le long d&amp;u trait…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Set a value along the stroke: constant, as a ramp, or drawn as a curve</source>
        <translation>Régler une valeur le long du trait : constante, en rampe ou dessinée en courbe</translation>
    </message>
    <message>
        <source>Vary at Rand&amp;om…</source>
        <translation>Varier au &amp;hasard…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Y</source>
        <translation>Ctrl+Alt+Y</translation>
    </message>
    <message>
        <source>Let values and colours of the selected strokes stray at random</source>
        <translation>Laisser valeurs et couleurs des traits sélectionnés s’écarter au hasard</translation>
    </message>
    <message>
        <source>Appl&amp;y Brush</source>
        <translation>Appli&amp;quer le pinceau</translation>
    </message>
    <message>
        <source>Show Erasures</source>
        <translation>Afficher les effacements</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>Dashed lines along what was erased softly from all strokes; what is not selected is paler</source>
        <translation>Lignes en pointillé le long de ce qui a été gommé en douceur de tous les traits ; ce qui n’est pas sélectionné est plus pâle</translation>
    </message>
    <message>
        <source>&amp;Combine</source>
        <translation>&amp;Combiner</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Make one stroke of the selected ones, whose paint adds up</source>
        <translation>Faire un seul trait des traits sélectionnés, dont la peinture s’additionne</translation>
    </message>
    <message>
        <source>Break Apart</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Make strokes of the parts of the selected ones</source>
        <translation>Faire des traits des parties de ceux sélectionnés</translation>
    </message>
    <message>
        <source>Remove Erasures</source>
        <translation>Supprimer les effacements</translation>
    </message>
    <message>
        <source>Bring back what was erased softly from the selected strokes, or by the selected segments</source>
        <translation>Restaurer ce qui a été effacé en douceur des traits sélectionnés, ou par les segments sélectionnés</translation>
    </message>
    <message>
        <source>Delete the selected segments, which leaves gaps in strokes</source>
        <translation>Supprimer les segments sélectionnés, ce qui laisse des lacunes dans les traits</translation>
    </message>
    <message>
        <source>Take paint away softly, or cut out parts of strokes</source>
        <translation>Enlever de la peinture en douceur, ou découper des parties de traits</translation>
    </message>
    <message>
        <source>Map Colours to S&amp;watches</source>
        <translation>Associer au&amp;x nuances</translation>
    </message>
    <message>
        <source>Give what is selected, or else all of the painting, the swatches that look nearest</source>
        <translation>Donner à la sélection, ou sinon à tout le tableau, les nuances les plus ressemblantes</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Give each colour of the painting, or of what is selected, another one everywhere</source>
        <translation>Donner partout une autre couleur à chaque couleur du tableau, ou de la sélection</translation>
    </message>
    <message>
        <source>Paste Appeara&amp;nce</source>
        <translation>Coller l’asp&amp;ect</translation>
    </message>
    <message>
        <source>Menu at t&amp;he Pointer</source>
        <translation>Menu au poi&amp;nteur</translation>
    </message>
    <message>
        <source>Recolour Artwor&amp;k…</source>
        <translation>Re&amp;définir les couleurs…</translation>
    </message>
    <message>
        <source>Match &amp;by Eyedropper</source>
        <translation>Asso&amp;rtir à la pipette</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its style, mixing, values and colour</source>
        <translation>Cliquer sur un trait : ceux qui sont sélectionnés prennent son style, son mélange, ses valeurs et sa couleur</translation>
    </message>
    <message>
        <source>A fill cannot be wetted again. It spreads as long as it takes to dry.</source>
        <translation>Un remplissage ne peut pas être réhumidifié. Il s’étale tant qu’il n’est pas sec.</translation>
    </message>
    <message>
        <source>Not done: nothing would be left.</source>
        <translation>Non effectué : il ne resterait rien.</translation>
    </message>
    <message>
        <source>Not done: the outlines meet so often that it would take minutes.</source>
        <translation>Non effectué : les contours se croisent si souvent que cela prendrait des minutes.</translation>
    </message>
    <message>
        <source>Not done: the outlines lie on each other so closely that the result is uncertain.</source>
        <translation>Non effectué : les contours sont si proches l’un de l’autre que le résultat est incertain.</translation>
    </message>
    <message>
        <source>Select two or more filled strokes.</source>
        <translation>Sélectionnez deux traits remplis ou plus.</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Union</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>One fill of what the selected ones cover, with the values of the lowest</source>
        <translation>Un seul remplissage de ce que couvrent les sélectionnés, avec les valeurs du plus bas</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Différence</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what the others do not cover</source>
        <translation>Ne laisser du plus bas remplissage sélectionné que ce que les autres ne couvrent pas</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>&amp;Intersection</translation>
    </message>
    <message>
        <source>Ctrl+*</source>
        <translation>Ctrl+*</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what all others cover</source>
        <translation>Ne laisser du plus bas remplissage sélectionné que ce que tous les autres couvrent</translation>
    </message>
    <message>
        <source>E&amp;xclusion</source>
        <translation>E&amp;xclusion</translation>
    </message>
    <message>
        <source>Ctrl+^</source>
        <translation>Ctrl+^</translation>
    </message>
    <message>
        <source>One fill of what one of the selected ones covers, and not two</source>
        <translation>Un seul remplissage de ce qu’un des sélectionnés couvre, et non deux</translation>
    </message>
    <message>
        <source>Di&amp;vision</source>
        <translation>Di&amp;vision</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Cut the lowest selected fill along the outlines of the others</source>
        <translation>Couper le plus bas remplissage sélectionné le long des contours des autres</translation>
    </message>
    <message>
        <source>Select a filled stroke.</source>
        <translation>Sélectionnez un trait rempli.</translation>
    </message>
    <message>
        <source>I&amp;nset</source>
        <translation>Ér&amp;oder</translation>
    </message>
    <message>
        <source>Ctrl+Alt+(</source>
        <translation>Ctrl+Alt+(</translation>
    </message>
    <message>
        <source>Move the outlines of fills inwards, by the distance of Offset and More</source>
        <translation>Déplacer les contours des remplissages vers l’intérieur, de la distance de Décaler et plus</translation>
    </message>
    <message>
        <source>&amp;Outset</source>
        <translation>Di&amp;later</translation>
    </message>
    <message>
        <source>Ctrl+Alt+)</source>
        <translation>Ctrl+Alt+)</translation>
    </message>
    <message>
        <source>Move the outlines of fills outwards, by the distance of Offset and More</source>
        <translation>Déplacer les contours des remplissages vers l’extérieur, de la distance de Décaler et plus</translation>
    </message>
    <message>
        <source>&amp;Stroke to Outline</source>
        <translation>&amp;Trait en contour</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Make fills of what is seen of the lines of the selected strokes</source>
        <translation>Faire des remplissages de ce que l’on voit des lignes des traits sélectionnés</translation>
    </message>
    <message>
        <source>Stroke to outline</source>
        <translation>Trait en contour</translation>
    </message>
    <message>
        <source>Select a stroke of which a line is seen.</source>
        <translation>Sélectionnez un trait dont on voit une ligne.</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>Outline Pe&amp;n</source>
        <translation>Plume à co&amp;ntours</translation>
    </message>
    <message>
        <source>Draw an outline node by node, filled or not</source>
        <translation>Dessiner un contour nœud par nœud, rempli ou non</translation>
    </message>
    <message>
        <source>Lasso F&amp;ill</source>
        <translation>Remplissage au &amp;lasso</translation>
    </message>
    <message>
        <source>Fill what is drawn around</source>
        <translation>Remplir ce que l’on entoure</translation>
    </message>
    <message>
        <source>Bu&amp;cket</source>
        <translation>Sea&amp;u</translation>
    </message>
    <message>
        <source>Fill what the paint around a place bounds</source>
        <translation>Remplir ce que délimite la peinture autour d’un endroit</translation>
    </message>
    <message>
        <source>Text to Strokes</source>
        <translation>Texte en traits</translation>
    </message>
    <message>
        <source>Make plain strokes of the letters of the selected texts; they cannot be typed in any more</source>
        <translation>Convertir les lettres des textes sélectionnés en traits ordinaires ; le texte n’est plus modifiable</translation>
    </message>
    <message>
        <source>Text to strokes</source>
        <translation>Texte en traits</translation>
    </message>
    <message>
        <source>Release Text from Stroke</source>
        <translation>Détacher le texte du trait</translation>
    </message>
    <message>
        <source>Let the selected texts keep their curves, whatever becomes of the strokes that they follow</source>
        <translation>Les textes sélectionnés gardent leurs courbes, quoi qu’il advienne des traits qu’ils suivent</translation>
    </message>
    <message>
        <source>Select a text that follows a stroke.</source>
        <translation>Sélectionnez un texte qui suit un trait.</translation>
    </message>
    <message>
        <source>Release text from stroke</source>
        <translation>Détacher le texte du trait</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>Te&amp;xte</translation>
    </message>
    <message>
        <source>Type texts, whose letters are strokes</source>
        <translation>Saisir des textes, dont les lettres sont des traits</translation>
    </message>
    <message>
        <source>&amp;Zoom to Selection</source>
        <translation>&amp;Zoomer sur la sélection</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Show what is selected as large as possible: strokes, segments or nodes</source>
        <translation>Montrer la sélection aussi grande que possible : traits, segments ou nœuds</translation>
    </message>
    <message>
        <source>Add Gradient</source>
        <translation>Ajouter un dégradé</translation>
    </message>
    <message>
        <source>The colour of the selected fills fades from left to right; needs a fill of one colour</source>
        <translation>La couleur des remplissages sélectionnés se fond de gauche à droite ; nécessite un remplissage d’une seule couleur</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Ajouter un dégradé</translation>
    </message>
    <message>
        <source>Remove Gradient</source>
        <translation>Supprimer le dégradé</translation>
    </message>
    <message>
        <source>The selected fills have their first colour everywhere; needs a fill with a gradient</source>
        <translation>Les remplissages sélectionnés ont partout leur première couleur ; nécessite un remplissage à dégradé</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Supprimer le dégradé</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Écrêter par le dessous</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>The selected groups are seen only where the next thing below them in the same group is; needs something below</source>
        <translation>Les groupes sélectionnés ne sont visibles que là où se trouve l’élément juste en dessous dans le même groupe ; nécessite quelque chose en dessous</translation>
    </message>
    <message>
        <source>Use as Mask</source>
        <translation>Utiliser comme masque</translation>
    </message>
    <message>
        <source>What is beside the selected groups is seen only where they have paint; needs something beside</source>
        <translation>Ce qui est à côté des groupes sélectionnés n’est visible que là où ils ont de la peinture ; nécessite quelque chose à côté</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Lavis</translation>
    </message>
    <message>
        <source>The strokes of the selected groups are one, laid wet into wet</source>
        <translation>Les traits des groupes sélectionnés ne font qu’un, posés mouillé sur mouillé</translation>
    </message>
    <message>
        <source>What the group did as a whole (opacity, mode, isolation, clip, mask, wash) is gone with it.</source>
        <translation>Ce que le groupe faisait dans son ensemble (opacité, mode, isolation, écrêtage, masque, lavis) disparaît avec lui.</translation>
    </message>
    <message>
        <source>Group as a Whole</source>
        <translation>Groupe dans son ensemble</translation>
    </message>
    <message>
        <source>Not merged: nothing lies below the layer in its group.</source>
        <translation>Non fusionné : il n’y a rien sous le calque dans son groupe.</translation>
    </message>
    <message>
        <source>Not merged: what lies just below the layer is no layer.</source>
        <translation>Non fusionné : ce qui est juste sous le calque n’est pas un calque.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is hidden.</source>
        <translation>Non fusionné : l’un des deux calques est masqué.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is locked.</source>
        <translation>Non fusionné : l’un des deux calques est verrouillé.</translation>
    </message>
    <message>
        <source>Merge layer down</source>
        <translation>Fusionner le calque vers le bas</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Dupliquer le calque</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>Monter le calque</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>Descendre le calque</translation>
    </message>
    <message>
        <source>&amp;New Layer</source>
        <translation>&amp;Nouveau calque</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paint on a new layer above this one; it comes with its first stroke</source>
        <translation>Peindre sur un nouveau calque au-dessus de celui-ci ; il apparaît avec son premier trait</translation>
    </message>
    <message>
        <source>New &amp;Clipped Layer</source>
        <translation>Nouveau calque é&amp;crêté</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Paint on a new layer that shows only where the layer below has paint: a clipping mask</source>
        <translation>Peindre sur un nouveau calque visible seulement là où le calque du dessous a de la peinture : un masque d’écrêtage</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>&amp;Dupliquer le calque</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>&amp;Fusionner vers le bas</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Raise Layer</source>
        <translation>&amp;Monter le calque</translation>
    </message>
    <message>
        <source>&amp;Lower Layer</source>
        <translation>De&amp;scendre le calque</translation>
    </message>
    <message>
        <source>Layer &amp;Above</source>
        <translation>Calque au-dess&amp;us</translation>
    </message>
    <message>
        <source>Paint on the next layer above; above all of them there is none</source>
        <translation>Peindre sur le calque suivant vers le haut ; au-dessus de tous, il n’y en a aucun</translation>
    </message>
    <message>
        <source>Layer &amp;Below</source>
        <translation>Calque au-dess&amp;ous</translation>
    </message>
    <message>
        <source>Paint on the next layer below</source>
        <translation>Peindre sur le calque suivant vers le bas</translation>
    </message>
    <message>
        <source>N&amp;o Layer</source>
        <translation>&amp;Aucun calque</translation>
    </message>
    <message>
        <source>Paint on top of all again</source>
        <translation>Peindre de nouveau par-dessus tout</translation>
    </message>
    <message>
        <source>&amp;Hide Others</source>
        <translation>Masquer les au&amp;tres</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Show only this layer, or all again</source>
        <translation>N’afficher que ce calque, ou de nouveau tous</translation>
    </message>
    <message>
        <source>Show other layers</source>
        <translation>Afficher les autres calques</translation>
    </message>
    <message>
        <source>Hide other layers</source>
        <translation>Masquer les autres calques</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Calque</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>Rien ne change.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is a mask, and the picture would change.</source>
        <translation>Non fusionné : l’un des deux calques est un masque, et l’image changerait.</translation>
    </message>
    <message>
        <source>Not merged: the layer below is clipped, and the picture would change.</source>
        <translation>Non fusionné : le calque du dessous est écrêté, et l’image changerait.</translation>
    </message>
    <message>
        <source>Not merged: what lies above is clipped to this layer, and the picture would change.</source>
        <translation>Non fusionné : ce qui est au-dessus est écrêté par ce calque, et l’image changerait.</translation>
    </message>
    <message>
        <source>So that the picture stays, %1 is a group of its own within %2.</source>
        <translation>Pour que l’image ne change pas, %1 est un groupe à part dans %2.</translation>
    </message>
    <message>
        <source>Put the layer onto the one just below it; the picture stays</source>
        <translation>Fusionner le calque avec celui juste en dessous ; l’image ne change pas</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>&amp;Calque</translation>
    </message>
    <message>
        <source>&amp;This Layer Only</source>
        <translation>Ce calque seu&amp;lement</translation>
    </message>
    <message>
        <source>Tools reach only what is on the layer, where there is one</source>
        <translation>Les outils n’atteignent que ce qui est sur le calque, s’il y en a un</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Ébauche</translation>
    </message>
    <message>
        <source>The selected groups are seen here, and left out of what is exported</source>
        <translation>Les groupes sélectionnés sont visibles ici, et omis de ce qui est exporté</translation>
    </message>
    <message>
        <source>Underlay to Layer</source>
        <translation>Modèle en calque</translation>
    </message>
    <message>
        <source>Make an image layer below all of the underlay, where it lies; it is exported then</source>
        <translation>Faire du modèle un calque d’image sous tout le reste, là où il se trouve ; il est alors exporté</translation>
    </message>
    <message>
        <source>Picture to Stro&amp;kes…</source>
        <translation>Image en &amp;traits…</translation>
    </message>
    <message>
        <source>Strokes that look like a picture, of a file or the underlay, as a layer</source>
        <translation>Des traits qui ressemblent à une image, d’un fichier ou du modèle, sous forme de calque</translation>
    </message>
    <message>
        <source>Import &amp;Picture as Layer…</source>
        <translation>Importer une image comme ca&amp;lque…</translation>
    </message>
    <message>
        <source>A picture as a layer among the others: with opacity and mode, and in what is exported</source>
        <translation>Une image comme calque parmi les autres : avec opacité et mode, et dans ce qui est exporté</translation>
    </message>
    <message>
        <source>Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one</source>
        <translation>Coller traits, chemins SVG ou image au pointeur ; une couleur devient la couleur actuelle</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>Exporter un &amp;dessin…</translation>
    </message>
    <message>
        <source>Prin&amp;t…</source>
        <translation>Im&amp;primer…</translation>
    </message>
    <message>
        <source>On paper, or as a page of a PDF file</source>
        <translation>Sur papier, ou comme page d’un fichier PDF</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>&amp;Aperçu avant impression…</translation>
    </message>
    <message>
        <source>See the page in large before it is printed</source>
        <translation>Voir la page en grand avant de l’imprimer</translation>
    </message>
    <message>
        <source>Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)</source>
        <translation>Contours exacts et bandes de peinture pour Inkscape, traceurs et navigateurs (SVG)</translation>
    </message>
    <message>
        <source>Soft Proof</source>
        <translation>Épreuve à l’écran</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>Shows the colours that are left on another device, as a press, by its profile</source>
        <translation>Montre les couleurs qu’il reste sur un autre périphérique, une presse par exemple, d’après son profil</translation>
    </message>
    <message>
        <source>Gamut &amp;Warning</source>
        <translation>Alerte de gam&amp;ut</translation>
    </message>
    <message>
        <source>Marks the colours that the device of the soft proof does not have</source>
        <translation>Marque les couleurs que le périphérique de l’épreuve à l’écran n’a pas</translation>
    </message>
    <message>
        <source>Soft Proof with Profile…</source>
        <translation>Épreuve à l’écran avec un profil…</translation>
    </message>
    <message>
        <source>Chooses the profile of the device whose colours are shown</source>
        <translation>Choisit le profil du périphérique dont les couleurs sont montrées</translation>
    </message>
    <message>
        <source>It is clipped to a layer that is hidden now, so nothing of it is seen.</source>
        <translation>Il est écrêté par un calque maintenant masqué : on n’en voit donc rien.</translation>
    </message>
    <message>
        <source>&amp;Fewer Strokes…</source>
        <translation>&amp;Moins de traits…</translation>
    </message>
    <message>
        <source>Make fewer strokes that look like the selected ones</source>
        <translation>Faire moins de traits qui ressemblent à ceux sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>What Suffuse does and how; the key opens the page about what you are working with</source>
        <translation>Ce que Suffuse fait et comment ; la touche ouvre la page sur ce que vous êtes en train de faire</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>&amp;Welcome…</source>
        <translation>&amp;Bienvenue…</translation>
    </message>
    <message>
        <source>New paintings, recent ones, samples, and short lessons</source>
        <translation>Nouveaux tableaux, tableaux récents, exemples et courtes leçons</translation>
    </message>
    <message>
        <source>Nothing is selected: click paint with Select first.</source>
        <translation>Rien n’est sélectionné : cliquez d’abord sur la peinture avec Sélection.</translation>
    </message>
    <message>
        <source>Nothing is painted yet.</source>
        <translation>Rien n’est encore peint.</translation>
    </message>
    <message>
        <source>Nothing is locked.</source>
        <translation>Rien n’est verrouillé.</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>Rien n’est masqué.</translation>
    </message>
    <message>
        <source>Select two strokes or more; to the canvas one can be aligned, too.</source>
        <translation>Sélectionnez deux traits ou plus ; sur le canevas, on peut aussi en aligner un seul.</translation>
    </message>
    <message>
        <source>No layer is chosen: click one in the Strokes dock, or begin one with New Layer.</source>
        <translation>Aucun calque n’est choisi : cliquez sur un calque du panneau Traits, ou créez-en un avec Nouveau calque.</translation>
    </message>
    <message>
        <source>The painting has no layers yet: New Layer begins one.</source>
        <translation>Le tableau n’a pas encore de calques : Nouveau calque en crée un.</translation>
    </message>
    <message>
        <source>Select a group that this can be.</source>
        <translation>Sélectionnez un groupe qui s’y prête.</translation>
    </message>
    <message>
        <source>Select strokes of a group.</source>
        <translation>Sélectionnez des traits d’un groupe.</translation>
    </message>
    <message>
        <source>Select a text.</source>
        <translation>Sélectionnez un texte.</translation>
    </message>
    <message>
        <source>Select strokes without a fill.</source>
        <translation>Sélectionnez des traits sans remplissage.</translation>
    </message>
    <message>
        <source>Select a fill of one colour.</source>
        <translation>Sélectionnez un remplissage d’une seule couleur.</translation>
    </message>
    <message>
        <source>Select a fill with a gradient.</source>
        <translation>Sélectionnez un remplissage à dégradé.</translation>
    </message>
    <message>
        <source>Select two strokes or more.</source>
        <translation>Sélectionnez deux traits ou plus.</translation>
    </message>
    <message>
        <source>Select a stroke that was combined or cut into parts.</source>
        <translation>Sélectionnez un trait qui a été combiné ou coupé en parties.</translation>
    </message>
    <message>
        <source>Select a stroke from which something was erased softly.</source>
        <translation>Sélectionnez un trait dont quelque chose a été effacé en douceur.</translation>
    </message>
    <message>
        <source>The painting has no underlay.</source>
        <translation>Le tableau n’a pas de modèle.</translation>
    </message>
    <message>
        <source>Select paint that was wetted again.</source>
        <translation>Sélectionnez de la peinture qui a été réhumidifiée.</translation>
    </message>
    <message>
        <source>Copy an appearance first.</source>
        <translation>Copiez d’abord un aspect.</translation>
    </message>
    <message>
        <source>The painting has no swatches.</source>
        <translation>Le tableau n’a pas de nuances.</translation>
    </message>
    <message>
        <source>The painting has no file yet: save it first.</source>
        <translation>Le tableau n’a pas encore de fichier : enregistrez-le d’abord.</translation>
    </message>
    <message>
        <source>The clipboard has nothing that can be painted.</source>
        <translation>Le presse-papiers n’a rien qui puisse être peint.</translation>
    </message>
    <message>
        <source>An export is still under way.</source>
        <translation>Une exportation est encore en cours.</translation>
    </message>
    <message>
        <source>Search in the Strokes dock first.</source>
        <translation>Faites d’abord une recherche dans le panneau Traits.</translation>
    </message>
    <message>
        <source>Switch the soft proof on first.</source>
        <translation>Activez d’abord l’épreuve à l’écran.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Il n’y a rien à annuler.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Il n’y a rien à rétablir.</translation>
    </message>
    <message>
        <source>Select nodes with Segments first.</source>
        <translation>Sélectionnez d’abord des nœuds avec Segments.</translation>
    </message>
    <message>
        <source>Select segments, or the nodes at their ends, with Segments first.</source>
        <translation>Sélectionnez d’abord, avec Segments, des segments ou les nœuds à leurs extrémités.</translation>
    </message>
    <message>
        <source>Select two end nodes with Segments first.</source>
        <translation>Sélectionnez d’abord, avec Segments, deux nœuds d’extrémité.</translation>
    </message>
    <message>
        <source>&amp;Show the Axes of the Symmetry</source>
        <translation>Afficher les axes de &amp;symétrie</translation>
    </message>
    <message>
        <source>Also the square that moves them and the disc that turns them</source>
        <translation>Avec le carré qui les déplace et le disque qui les tourne</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Horizontal place</source>
        <translation>Position horizontale</translation>
    </message>
    <message>
        <source>Vertical place</source>
        <translation>Position verticale</translation>
    </message>
    <message>
        <source>Show the &amp;Rulers</source>
        <translation>Afficher les &amp;règles</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Along the upper and the left edge; guides are dragged out of them, and back into them</source>
        <translation>Le long des bords supérieur et gauche ; on en tire les guides, et on les y remet</translation>
    </message>
    <message>
        <source>Show the &amp;Guides</source>
        <translation>Afficher les &amp;guides</translation>
    </message>
    <message>
        <source>&amp;Snap to Guides</source>
        <translation>&amp;Aimanter aux guides</translation>
    </message>
    <message>
        <source>Nodes, shapes and what is moved; paint goes where the hand goes</source>
        <translation>Nœuds, formes et ce que l’on déplace ; la peinture va où va la main</translation>
    </message>
    <message>
        <source>&amp;Lock the Guides</source>
        <translation>&amp;Verrouiller les guides</translation>
    </message>
    <message>
        <source>They cannot be dragged, and new ones still can be made</source>
        <translation>On ne peut plus les déplacer, mais on peut toujours en créer</translation>
    </message>
    <message>
        <source>Add a Le&amp;vel Guide…</source>
        <translation>Ajouter un guide &amp;horizontal…</translation>
    </message>
    <message>
        <source>Add an &amp;Upright Guide…</source>
        <translation>Ajouter un guide ver&amp;tical…</translation>
    </message>
    <message>
        <source>Remove &amp;All Guides</source>
        <translation>&amp;Supprimer tous les guides</translation>
    </message>
    <message>
        <source>S&amp;how the Assistants</source>
        <translation>A&amp;fficher les assistants</translation>
    </message>
    <message>
        <source>Nothing is led by those that are not seen</source>
        <translation>Ceux que l’on ne voit pas ne guident aucun trait</translation>
    </message>
    <message>
        <source>&amp;Snap to Assistants</source>
        <translation>&amp;Magnétiser aux assistants</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>A stroke of the Brush follows the assistant whose direction it begins with</source>
        <translation>Un trait du pinceau suit l’assistant dans la direction duquel il commence</translation>
    </message>
    <message>
        <source>Remove &amp;All Assistants</source>
        <translation>&amp;Supprimer tous les assistants</translation>
    </message>
    <message>
        <source>There are no assistants.</source>
        <translation>Il n’y a pas d’assistants.</translation>
    </message>
    <message>
        <source>Assistants</source>
        <translation>Assistants</translation>
    </message>
    <message>
        <source>Lines, vanishing points and ellipses that lead strokes</source>
        <translation>Lignes, points de fuite et ellipses qui guident les traits</translation>
    </message>
    <message>
        <source>Mirrored &amp;Left and Right</source>
        <translation>Miroir &amp;gauche-droite</translation>
    </message>
    <message>
        <source>What is painted on one side of an upright axis comes on the other, too</source>
        <translation>Ce que l’on peint d’un côté d’un axe vertical apparaît aussi de l’autre</translation>
    </message>
    <message>
        <source>Mirrored &amp;Top and Bottom</source>
        <translation>Miroir &amp;haut-bas</translation>
    </message>
    <message>
        <source>What is painted above a level axis comes below it, too</source>
        <translation>Ce que l’on peint au-dessus d’un axe horizontal apparaît aussi en dessous</translation>
    </message>
    <message>
        <source>Mirrored &amp;Both Ways</source>
        <translation>Miroir dans les &amp;deux sens</translation>
    </message>
    <message>
        <source>What is painted comes in all four corners of a cross</source>
        <translation>Ce que l’on peint apparaît dans les quatre coins d’une croix</translation>
    </message>
    <message>
        <source>&amp;Rotated around the Centre</source>
        <translation>&amp;Rotation autour du centre</translation>
    </message>
    <message>
        <source>What is painted comes once in each arm around the centre</source>
        <translation>Ce que l’on peint apparaît une fois dans chaque branche autour du centre</translation>
    </message>
    <message>
        <source>&amp;Kaleidoscope</source>
        <translation>&amp;Kaléidoscope</translation>
    </message>
    <message>
        <source>What is painted comes in each arm around the centre, and mirrored beside it</source>
        <translation>Ce que l’on peint apparaît dans chaque branche autour du centre, et en miroir à côté</translation>
    </message>
    <message>
        <source>&amp;Paint in Symmetry</source>
        <translation>&amp;Peindre en symétrie</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step</source>
        <translation>Traits, formes et contours sont répétés, en miroir ou tournés, en une seule étape d’annulation</translation>
    </message>
    <message>
        <source>Number of &amp;Arms…</source>
        <translation>Nombre de &amp;branches…</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Arms around the centre</source>
        <translation>Branches autour du centre</translation>
    </message>
    <message>
        <source>An&amp;gle of the Axes…</source>
        <translation>&amp;Angle des axes…</translation>
    </message>
    <message>
        <source>Degrees clockwise</source>
        <translation>Degrés dans le sens horaire</translation>
    </message>
    <message>
        <source>Axes to the &amp;Middle of the Canvas</source>
        <translation>Axes au &amp;milieu du canevas</translation>
    </message>
    <message>
        <source>The centre of the symmetry lies in the middle again, and the axes are upright and level</source>
        <translation>Le centre de la symétrie revient au milieu, et les axes sont vertical et horizontal</translation>
    </message>
    <message>
        <source>Rulers and Guides</source>
        <translation>Règles et guides</translation>
    </message>
    <message>
        <source>Workspace to &amp;Paint</source>
        <translation>Espace de travail pour &amp;peindre</translation>
    </message>
    <message>
        <source>Colour, brushes and strokes beside a wide canvas</source>
        <translation>Couleur, pinceaux et traits à côté d’un large canevas</translation>
    </message>
    <message>
        <source>Workspace to &amp;Refine</source>
        <translation>Espace de travail pour &amp;retoucher</translation>
    </message>
    <message>
        <source>Inspector, strokes, history and colour</source>
        <translation>Inspecteur, traits, historique et couleur</translation>
    </message>
    <message>
        <source>Workspace for &amp;Time</source>
        <translation>Espace de travail pour le &amp;temps</translation>
    </message>
    <message>
        <source>A high timeline, with inspector and strokes</source>
        <translation>Une haute chronologie, avec inspecteur et traits</translation>
    </message>
    <message>
        <source>&amp;Save Workspace…</source>
        <translation>&amp;Enregistrer l’espace de travail…</translation>
    </message>
    <message>
        <source>Keep where docks and tool bars stand now, under a name</source>
        <translation>Garder sous un nom la disposition actuelle des panneaux et barres d’outils</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>Espaces de travail</translation>
    </message>
    <message>
        <source>Rulers in &amp;Canvas Units</source>
        <translation>Règles en &amp;unités de canevas</translation>
    </message>
    <message>
        <source>Rulers in &amp;Millimetres</source>
        <translation>Règles en &amp;millimètres</translation>
    </message>
    <message>
        <source>Rulers in &amp;Inches</source>
        <translation>Règles en p&amp;ouces</translation>
    </message>
    <message>
        <source>New View</source>
        <translation>Nouvelle vue</translation>
    </message>
    <message>
        <source>A window that shows the painting from elsewhere while you paint; each edit shows in both</source>
        <translation>Une fenêtre qui montre le tableau sous une autre vue pendant que vous peignez ; chaque modification s’affiche dans les deux</translation>
    </message>
    <message>
        <source>&amp;Repeat Last Extension</source>
        <translation>&amp;Répéter la dernière extension</translation>
    </message>
    <message>
        <source>Ctrl+Alt+X</source>
        <translation>Ctrl+Alt+X</translation>
    </message>
    <message>
        <source>Once more, with the same values</source>
        <translation>Encore une fois, avec les mêmes valeurs</translation>
    </message>
    <message>
        <source>&amp;Manage Extensions…</source>
        <translation>&amp;Gérer les extensions…</translation>
    </message>
    <message>
        <source>Which extensions there are, which are in the menu, and what went wrong</source>
        <translation>Quelles extensions il y a, lesquelles sont dans le menu, et ce qui a échoué</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected.</source>
        <translation>Rien de visible et de non verrouillé n’est sélectionné.</translation>
    </message>
    <message>
        <source>E&amp;xtensions</source>
        <translation>E&amp;xtensions</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Paint with Ke&amp;ys</source>
        <translation>Peindre avec les touc&amp;hes</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it</source>
        <translation>Les touches fléchées déplacent un réticule sur le canevas, Espace abaisse l’outil utilisé et le relève</translation>
    </message>
    <message>
        <source>There are no guides.</source>
        <translation>Il n’y a pas de guides.</translation>
    </message>
    <message>
        <source>Choose a symmetry that turns, or the kaleidoscope, first.</source>
        <translation>Choisissez d’abord une symétrie qui tourne, ou le kaléidoscope.</translation>
    </message>
    <message>
        <source>No extension has run yet.</source>
        <translation>Aucune extension n’a encore été exécutée.</translation>
    </message>
</context>
<context>
    <name>suffuse::CompareButton</name>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Shows the picture as it was before the last changes to the selection: while held, or click to switch back and forth.</source>
        <translation>Montre l’image d’avant les dernières modifications de la sélection : maintenir, ou cliquer pour basculer.</translation>
    </message>
</context>
<context>
    <name>suffuse::CrossSectionPlot</name>
    <message>
        <source>Not painted yet</source>
        <translation>Pas encore peint</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>coupe transversale</translation>
    </message>
    <message>
        <source>Covers up to %1</source>
        <translation>Couvre jusqu’à %1</translation>
    </message>
</context>
<context>
    <name>suffuse::CurrentLayer</name>
    <message>
        <source>Layer: %1</source>
        <translation>Calque : %1</translation>
    </message>
    <message>
        <source>No layer: paint goes on top of all</source>
        <translation>Aucun calque : la peinture va par-dessus tout</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Calque %1</translation>
    </message>
    <message>
        <source>New layer: %1. Paint on it.</source>
        <translation>Nouveau calque : %1. Peignez dessus.</translation>
    </message>
    <message>
        <source>New clipped layer: %1. Paint on it, where the layer below has paint.</source>
        <translation>Nouveau calque écrêté : %1. Peignez dessus, là où le calque du dessous a de la peinture.</translation>
    </message>
    <message>
        <source>All is shown again, since this would be hidden</source>
        <translation>Tout est de nouveau affiché, sinon celui-ci serait masqué</translation>
    </message>
    <message>
        <source>%1 is locked: nothing is painted there</source>
        <translation>%1 est verrouillé : rien n’y est peint</translation>
    </message>
    <message>
        <source>%1 is hidden: nothing is painted there</source>
        <translation>%1 est masqué : rien n’y est peint</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copie</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 copie %2</translation>
    </message>
    <message>
        <source>Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.</source>
        <translation>Seul ce qui est sur %1 est atteint. Calque ▸ Ce calque seulement redonne accès à tout.</translation>
    </message>
</context>
<context>
    <name>suffuse::CurveEditor</name>
    <message>
        <source>along the stroke →</source>
        <translation>le long du trait →</translation>
    </message>
</context>
<context>
    <name>suffuse::DensityPlot</name>
    <message>
        <source>Coverage at the peak density %1: %2 %</source>
        <translation>Couverture à la densité maximale %1 : %2 %</translation>
    </message>
    <message>
        <source>density φ — first of several styles</source>
        <translation>densité φ — premier de plusieurs styles</translation>
    </message>
    <message>
        <source>density φ</source>
        <translation>densité φ</translation>
    </message>
    <message>
        <source>F(φ), peak %1</source>
        <translation>F(φ), maximum %1</translation>
    </message>
</context>
<context>
    <name>suffuse::Docks</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>Dispo&amp;ser</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinceaux</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingTool</name>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>What was drawn encloses no area: nothing was added.</source>
        <translation>Ce qui a été dessiné n’entoure aucune surface : rien n’a été ajouté.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Outline and fill</source>
        <translation>Contour et remplissage</translation>
    </message>
    <message>
        <source>What of the shape is painted</source>
        <translation>Ce qui est peint de la forme</translation>
    </message>
</context>
<context>
    <name>suffuse::Editor</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <extracomment>name of a document that was brought back after a crash</extracomment>
        <translation>%1 (récupéré)</translation>
    </message>
    <message>
        <source>is damaged, so the painting stays as it is; save it, or open the file to see what is whole of it</source>
        <translation>est endommagé, le tableau reste donc tel quel ; enregistrez-le, ou ouvrez le fichier pour voir ce qui en est intact</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revenir au fichier</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserFields</name>
    <message>
        <source>Fade</source>
        <translation>Atténuer</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Éponger</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges draw in; Cut cuts curves out</source>
        <translation>Atténuer rend la peinture plus pâle, partout où on la voit ; Éponger enlève sa densité, si bien que les bords se retirent ; Couper découpe les courbes</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>How far what is taken away spreads, as a share of the radius</source>
        <translation>Jusqu’où s’étale ce qui est enlevé, en proportion du rayon</translation>
    </message>
    <message>
        <source>Selected Strokes</source>
        <extracomment>scope of the eraser, while no stroke is selected</extracomment>
        <translation>Traits sélectionnés</translation>
    </message>
    <message>
        <source>Current Group</source>
        <translation>Groupe actuel</translation>
    </message>
    <message>
        <source>All Strokes</source>
        <translation>Tous les traits</translation>
    </message>
    <message>
        <source>From which strokes; without a selection, the first choice means all</source>
        <translation>De quels traits ; sans sélection, le premier choix signifie tous</translation>
    </message>
    <message>
        <source>All (None Selected)</source>
        <translation>Tous (rien de sélectionné)</translation>
    </message>
    <message>
        <source>Fade: the share of the paint that is taken. Lift: how much density, so that feathered paint gets paler and paint with a sharp edge narrower. A pen&apos;s pressure takes from it</source>
        <translation>Atténuer : la part de peinture enlevée. Éponger : combien de densité ; la peinture à bords fondus pâlit, celle à bord net rétrécit. Un appui léger du stylet en réduit l’effet</translation>
    </message>
    <message>
        <source>Sharp edges draw in.</source>
        <translation>Les bords nets se retirent.</translation>
    </message>
</context>
<context>
    <name>suffuse::ErasureRows</name>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Fade makes paint paler; Lift takes its density away, so that edges draw in.</source>
        <translation>Atténuer rend la peinture plus pâle ; Éponger enlève sa densité, si bien que les bords se retirent.</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Atténuer</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Éponger</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>The diameter of the eraser, if its softness was the usual one.</source>
        <translation>Le diamètre de la gomme, si sa douceur était celle d’usage.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>The share of the paint that it takes in its middle.</source>
        <translation>La part de peinture qu’il enlève en son milieu.</translation>
    </message>
    <message>
        <source>Density taken</source>
        <translation>Densité enlevée</translation>
    </message>
    <message>
        <source>Change size</source>
        <translation>Modifier la taille</translation>
    </message>
    <message>
        <source>The density that it takes away in its middle: paint that is thinner is gone there.</source>
        <translation>La densité qu’il enlève en son milieu : la peinture plus mince y disparaît.</translation>
    </message>
    <message>
        <source>Change strength</source>
        <translation>Changer l’intensité</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
    <message>
        <source>Change kind of erasure</source>
        <translation>Changer le type d’effacement</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserTool</name>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atténuer : glisser pour rendre plus pâles les traits sélectionnés, selon l’intensité. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atténuer : glisser pour rendre plus pâles les traits du groupe, selon l’intensité. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Atténuer : glisser pour rendre la peinture plus pâle, selon l’intensité, partout où on la voit. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Éponger : glisser pour enlever en douceur la peinture des traits sélectionnés. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Éponger : glisser pour enlever en douceur la peinture des traits du groupe. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Éponger : glisser pour enlever en douceur la peinture, partout où on la voit. Maj : couper. [ et ] : taille, { et } : intensité.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Couper : glisser pour découper la partie des courbes sélectionnées sous le cercle. Maj : effacer en douceur. [ et ] : taille.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the group&apos;s curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Couper : glisser pour découper la partie des courbes du groupe sous le cercle. Maj : effacer en douceur. [ et ] : taille.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Couper : glisser pour découper la partie des courbes sous le cercle. Maj : effacer en douceur. [ et ] : taille.</translation>
    </message>
    <message>
        <source>Nothing is erased: no paint is seen under the circle.</source>
        <translation>Rien n’est effacé : on ne voit pas de peinture sous le cercle.</translation>
    </message>
    <message>
        <source>Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.</source>
        <translation>Rien n’est coupé : aucune courbe n’est sous le cercle. Atténuer enlève de la peinture partout où on la voit.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not selected.</source>
        <translation>Rien n’est effacé : ce qui est sous le cercle n’est pas sélectionné.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is in another group.</source>
        <translation>Rien n’est effacé : ce qui est sous le cercle est dans un autre groupe.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is locked.</source>
        <translation>Rien n’est effacé : ce qui est sous le cercle est verrouillé.</translation>
    </message>
    <message>
        <source>It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes its paint away.</source>
        <translation>Coupé, mais on voit à peine une lacune : ses bords sont plus doux que la coupe n’est large. Atténuer enlève sa peinture.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not on the layer, and only that is reached.</source>
        <translation>Rien n’est effacé : ce qui est sous le cercle n’est pas sur le calque, et lui seul est atteint.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportDialog</name>
    <message>
        <source>8 bit</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>16 bit floating point</source>
        <translation>16 bits à virgule flottante</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 bits à virgule flottante</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers.</source>
        <translation>L’extension choisit le format : png, tiff, exr, jpg, webp ou pfm, ou bien ora ou psd avec calques.</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Choisir un dossier et un nom</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Precision of each colour channel</source>
        <translation>Précision de chaque canal de couleur</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Of JPEG and WebP; 100 is the best. WebP loses nothing then.</source>
        <translation>Pour JPEG et WebP ; 100 est la meilleure. WebP est alors sans perte.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Arrière-plan transparent</translation>
    </message>
    <message>
        <source>Leaves the background out and stores how much the paint covers.</source>
        <translation>Omet l’arrière-plan et enregistre à quel point la peinture couvre.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Largeur en pixels</translation>
    </message>
    <message>
        <source>Width in pixels; the height follows.</source>
        <translation>Largeur en pixels ; la hauteur suit.</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Hauteur en pixels</translation>
    </message>
    <message>
        <source>Height in pixels; the width follows.</source>
        <translation>Hauteur en pixels ; la largeur suit.</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>tableau</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>“%1” has no ending of a picture format. Choose one of: %2.</source>
        <translation>« %1 » n’a pas d’extension de format d’image. Choisissez-en une : %2.</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 existe. Le remplacer ?</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>Exp&amp;orter</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Ce qu’il contient maintenant est perdu.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>At most %1 × %2 px</source>
        <translation>Au plus %1 × %2 px</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exporter une image</translation>
    </message>
    <message>
        <source>No picture format</source>
        <translation>Pas de format d’image</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What is written. The ending of the file&apos;s name says the same.</source>
        <translation>Ce qui est écrit. L’extension du nom de fichier dit la même chose.</translation>
    </message>
    <message>
        <source>Pictures are written here. File ▸ Export Drawing writes SVG.</source>
        <translation>Ici, on écrit des images. Fichier ▸ Exporter un dessin écrit du SVG.</translation>
    </message>
    <message>
        <source>Photoshop (layers)</source>
        <translation>Photoshop (calques)</translation>
    </message>
    <message>
        <source>OpenRaster (layers)</source>
        <translation>OpenRaster (calques)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>The colour profile that the file has. The painting keeps the one that was chosen from a file.</source>
        <translation>Le profil de couleur du fichier. Le tableau garde celui qui a été choisi dans un fichier.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportJob</name>
    <message>
        <source>A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.</source>
        <translation>Une image de %1 × %2 pixels ne tient pas en mémoire. Choisissez une taille plus petite.</translation>
    </message>
</context>
<context>
    <name>suffuse::Exporting</name>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté dans %1</translation>
    </message>
    <message>
        <source>Printed to %1</source>
        <translation>Imprimé dans %1</translation>
    </message>
    <message>
        <source>Given to the printer %1</source>
        <translation>Transmis à l’imprimante %1</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Exportation de %1…</translation>
    </message>
</context>
<context>
    <name>suffuse::EyedropperTool</name>
    <message>
        <source>Click to take the picture&apos;s colour as the current one. Shift: the stroke&apos;s own colour.</source>
        <translation>Cliquer pour prendre la couleur de l’image comme couleur actuelle. Maj : la couleur propre du trait.</translation>
    </message>
    <message>
        <source>A click takes</source>
        <translation>Un clic prend</translation>
    </message>
    <message>
        <source>The colour, to paint with</source>
        <translation>La couleur, pour peindre</translation>
    </message>
    <message>
        <source>The appearance, for the selection</source>
        <translation>L’aspect, pour la sélection</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Assortir</translation>
    </message>
    <message>
        <source>Select strokes first: they get the appearance of the stroke you click.</source>
        <translation>Sélectionnez d’abord des traits : ils prennent l’aspect du trait sur lequel vous cliquez.</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its appearance, and what varies along them stays. Shift: the same values all along.</source>
        <translation>Cliquer sur un trait : la sélection prend son aspect et garde ce qui varie sur sa longueur. Maj : les mêmes valeurs tout du long.</translation>
    </message>
    <message>
        <source>Click to give what is selected the picture&apos;s colour. Shift: the stroke&apos;s own colour. Ctrl: its whole appearance.</source>
        <translation>Cliquer pour donner à la sélection la couleur de l’image. Maj : la couleur propre du trait. Ctrl : tout son aspect.</translation>
    </message>
    <message>
        <source>Click to give the swatch the picture&apos;s colour. Shift: the stroke&apos;s own colour.</source>
        <translation>Cliquer pour donner à la nuance la couleur de l’image. Maj : la couleur propre du trait.</translation>
    </message>
    <message>
        <source>A colour, or style, values and colour of a stroke for the selected ones. The colour is for what the Colour dock shows: the brush, the selection or a swatch.</source>
        <translation>Une couleur, ou style, valeurs et couleur d’un trait pour la sélection. La couleur va à ce que montre le panneau Couleur : pinceau, sélection ou nuance.</translation>
    </message>
    <message>
        <source>The colour, for the selection</source>
        <translation>La couleur, pour la sélection</translation>
    </message>
    <message>
        <source>The colour, for the swatch</source>
        <translation>La couleur, pour la nuance</translation>
    </message>
</context>
<context>
    <name>suffuse::FiguresSection</name>
    <message>
        <source>The outline lays no paint: its density φ is 0. What is seen is the fill.</source>
        <translation>Le contour ne pose pas de peinture : sa densité φ vaut 0. Ce que l’on voit est le remplissage.</translation>
    </message>
    <message>
        <source>Density function</source>
        <translation>Fonction de densité</translation>
    </message>
    <message>
        <source>How density becomes coverage. The mark is the peak density of the selected segments.</source>
        <translation>Comment la densité devient couverture. Le repère est la densité maximale des segments sélectionnés.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Coupe transversale</translation>
    </message>
    <message>
        <source>The cut through the stroke at the first selected segment, at the moment shown: coverage, on the colour that it has on the background.</source>
        <translation>La coupe du trait au premier segment sélectionné, au moment affiché : la couverture, sur la couleur qu’il a sur l’arrière-plan.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Spread s</source>
        <translation>Étalement s</translation>
    </message>
    <message>
        <source>Peak density</source>
        <translation>Densité maximale</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Demi-largeur</translation>
    </message>
    <message>
        <source>Fades away</source>
        <translation>Disparaît</translation>
    </message>
    <message>
        <source>Density in the middle of a long straight stroke, dry.</source>
        <translation>Densité au milieu d’un long trait droit, sec.</translation>
    </message>
    <message>
        <source>From the middle to the visible edge of a long straight stroke, dry.</source>
        <translation>Du milieu au bord visible d’un long trait droit, sec.</translation>
    </message>
    <message>
        <source>When the paint has spread so thin that nothing of it is visible any more.</source>
        <translation>Quand la peinture s’est étalée si finement qu’on n’en voit plus rien.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>partly, from %1</source>
        <translation>en partie, dès %1</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>après %1</translation>
    </message>
    <message>
        <source>Spread along</source>
        <translation>Étalement en long</translation>
    </message>
    <message>
        <source>How far the paint has spread across the curve once it is dry: √(4·D·t_max).</source>
        <translation>Jusqu’où la peinture s’est étalée en travers de la courbe une fois sèche : √(4·D·t_max).</translation>
    </message>
    <message>
        <source>How far it has spread along the curve.</source>
        <translation>Jusqu’où elle s’est étalée le long de la courbe.</translation>
    </message>
    <message>
        <source>Spread across</source>
        <translation>Étalement en large</translation>
    </message>
    <message>
        <source>Takes away</source>
        <translation>Enlève</translation>
    </message>
    <message>
        <source>How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max).</source>
        <translation>Avec quelle douceur finit l’effacement : jusqu’où il s’est étalé à côté de sa courbe, √(4·D·t_max).</translation>
    </message>
    <message>
        <source>What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if it lifts, and paint that is thinner is gone there.</source>
        <translation>Ce qu’un segment de l’effacement enlève en son milieu : une part de la peinture s’il atténue ; de la densité s’il éponge, et une peinture plus mince y disparaît.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileOpening</name>
    <message>
        <source>Pictures with layers (*.ora *.psd)</source>
        <translation>Images à calques (*.ora *.psd)</translation>
    </message>
    <message>
        <source>All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</source>
        <translation>Tout ce qui peut être ouvert (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</translation>
    </message>
    <message>
        <source>Suffuse paintings (*.suffuse *.json)</source>
        <translation>Tableaux Suffuse (*.suffuse *.json)</translation>
    </message>
    <message>
        <source>Backups of paintings (*.suffuse~* *.json~*)</source>
        <translation>Sauvegardes de tableaux (*.suffuse~* *.json~*)</translation>
    </message>
    <message>
        <source>Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</source>
        <translation>Enregistrements au stylet (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</translation>
    </message>
    <message>
        <source>Drawings (*.svg *.svgz *.pdf)</source>
        <translation>Dessins (*.svg *.svgz *.pdf)</translation>
    </message>
    <message>
        <source>Diffusion curves (*.xml)</source>
        <translation>Courbes de diffusion (*.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>“%1” is open already.</source>
        <translation>« %1 » est déjà ouvert.</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was opened; the file itself is left as it is.</source>
        <translation>« %1 » est endommagé. Ce qui en est intact a été ouvert ; le fichier lui-même reste tel quel.</translation>
    </message>
    <message>
        <source>&amp;Clear the List</source>
        <translation>&amp;Vider la liste</translation>
    </message>
</context>
<context>
    <name>suffuse::FileRestoring</name>
    <message>
        <source>Revert “%1” to what the file holds?</source>
        <translation>Revenir à l’état enregistré de « %1 » ?</translation>
    </message>
    <message>
        <source>What was painted since the last save goes; Undo brings it back.</source>
        <translation>Ce qui a été peint depuis le dernier enregistrement disparaît ; Annuler le restaure.</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>&amp;Revenir</translation>
    </message>
    <message>
        <source>Restore backup of %1</source>
        <translation>Restaurer la sauvegarde de %1</translation>
    </message>
    <message>
        <source>The backup of %1 is back. Undo takes it away again; no file changes until you save.</source>
        <translation>La sauvegarde de %1 est restaurée. Annuler la retire ; aucun fichier ne change tant que vous n’enregistrez pas.</translation>
    </message>
    <message>
        <source>The backup of %1 is what you see: nothing has changed.</source>
        <translation>La sauvegarde de %1 est ce que vous voyez : rien n’a changé.</translation>
    </message>
    <message>
        <source>The backup is damaged. What is whole of it was restored.</source>
        <translation>La sauvegarde est endommagée. Ce qui en est intact a été restauré.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileSaving</name>
    <message>
        <source>What you paint now would not survive a crash: %1. Painting goes on; save from time to time.</source>
        <translation>Ce que vous peignez maintenant ne survivrait pas à un plantage : %1. Vous pouvez continuer à peindre ; enregistrez de temps en temps.</translation>
    </message>
    <message>
        <source>“%1” is gone from its folder. Save to put it back.</source>
        <translation>« %1 » a disparu de son dossier. Enregistrez pour le remettre.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>name of the file that a copy is saved to, beside that of the painting</extracomment>
        <translation>%1 copie</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Enregistrer une copie</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Enregistrement de « %1 »…</translation>
    </message>
    <message>
        <source>A copy is saved as “%1”.</source>
        <translation>Une copie est enregistrée sous « %1 ».</translation>
    </message>
    <message>
        <source>“%1” is saved already.</source>
        <translation>« %1 » est déjà enregistré.</translation>
    </message>
    <message>
        <source>%1 (without what is still being drawn)</source>
        <translation>%1 (sans ce qui est en cours de dessin)</translation>
    </message>
    <message>
        <source>Saved “%1”, %2</source>
        <translation>« %1 » enregistré, %2</translation>
    </message>
    <message>
        <source>Saved “%1”, but %2</source>
        <translation>« %1 » enregistré, mais %2</translation>
    </message>
    <message>
        <source>“%1” is not saved.</source>
        <translation>« %1 » n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Tableau Suffuse</translation>
    </message>
    <message>
        <source>Text form</source>
        <translation>Forme textuelle</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Choose another name, or close that window first.</source>
        <translation>« %1 » est ouvert dans une autre fenêtre. Choisissez un autre nom, ou fermez d’abord cette fenêtre.</translation>
    </message>
    <message>
        <source>“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.</source>
        <translation>« %1 » a des lignes et surfaces simples, pour d’autres programmes. Exporter un dessin garde les bords doux et sombres.</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>Dessin SVG</translation>
    </message>
</context>
<context>
    <name>suffuse::FileTypes</name>
    <message>
        <source>Suffuse painting</source>
        <translation>Tableau Suffuse</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Pinceau Suffuse</translation>
    </message>
    <message>
        <source>Backup of a painting</source>
        <translation>Sauvegarde d’un tableau</translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>%n calque de réglage ou de remplissage</numerusform>
            <numerusform>%n calques de réglage ou de remplissage</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>les effets de %n calque</numerusform>
            <numerusform>les effets de %n calques</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>le masque de %n groupe</numerusform>
            <numerusform>les masques de %n groupes</numerusform>
        </translation>
    </message>
    <message>
        <source>This Photoshop file is damaged.</source>
        <translation>Ce fichier Photoshop est endommagé.</translation>
    </message>
    <message>
        <source>Photoshop picture</source>
        <translation>Image Photoshop</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.</source>
        <translation>Les fichiers Photoshop de plus de 30 000 pixels par côté (PSB) ne sont pas lus. Enregistrez-le en PSD.</translation>
    </message>
    <message>
        <source>Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.</source>
        <translation>Seuls les fichiers Photoshop en RVB ou en gris, de 8 ou 16 bits, sont lus. Convertissez-le en RVB.</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>%n calque dont l’image manque, est endommagée ou trop grande</numerusform>
            <numerusform>%n calques dont l’image manque, est endommagée ou trop grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>le mode de %n calque</numerusform>
            <numerusform>les modes de %n calques</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: %1.</source>
        <translation>Ce fichier OpenRaster est endommagé : %1.</translation>
    </message>
    <message>
        <source>it has no list of its layers</source>
        <translation>il n’a pas de liste de ses calques</translation>
    </message>
    <message>
        <source>its list of layers cannot be read</source>
        <translation>la liste de ses calques est illisible</translation>
    </message>
    <message>
        <source>is a folder; give a file name inside it</source>
        <translation>est un dossier ; donnez le nom d’un fichier de ce dossier</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file; save to a file</source>
        <translation>est un périphérique ou un tube, pas un fichier ; enregistrez dans un fichier</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; create it or choose another one</source>
        <translation>le dossier %1 n’existe pas ; créez-le ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>%1 is not a folder; choose another place</source>
        <translation>%1 n’est pas un dossier ; choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>the folder %1 is read-only; choose another one or change its permissions</source>
        <translation>le dossier %1 est en lecture seule ; choisissez-en un autre ou modifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>The file has no name; choose one</source>
        <translation>Le fichier n’a pas de nom ; choisissez-en un</translation>
    </message>
    <message>
        <source>would have more than 2 GB; nothing was written</source>
        <translation>dépasserait 2 Go ; rien n’a été écrit</translation>
    </message>
    <message>
        <source>cannot be written (%1); choose another place</source>
        <translation>écriture impossible (%1) ; choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>%1 (%2); the old file, if there was one, is as before. Free some space or choose another place</source>
        <translation>%1 (%2) ; l’ancien fichier, s’il y en avait un, est comme avant. Libérez de l’espace ou choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>could not be written in full</source>
        <translation>n’a pas pu être écrit en entier</translation>
    </message>
    <message>
        <source>could not be put in place</source>
        <translation>n’a pas pu être mis en place</translation>
    </message>
    <message>
        <source>was written, but the folder could not be brought to the disk (%1); save once more before you switch off</source>
        <translation>a été écrit, mais le dossier n’a pas pu être transmis au disque (%1) ; enregistrez encore une fois avant d’éteindre</translation>
    </message>
    <message>
        <source>the image has %1 MB; at most 64 MB are possible, make it smaller</source>
        <translation>l’image fait %1 Mo ; au plus 64 Mo sont possibles, réduisez-la</translation>
    </message>
    <message>
        <source>is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them</source>
        <translation>n’est pas une image PNG, JPEG, TIFF, WebP ou EXR ; convertissez-la d’abord</translation>
    </message>
    <message>
        <source>is empty; give a data: URL or the path of an image file</source>
        <translation>est vide ; donnez une URL data: ou le chemin d’un fichier image</translation>
    </message>
    <message>
        <source>the image file %1 is missing; put it there or correct the path</source>
        <translation>le fichier image %1 manque ; mettez-le là ou corrigez le chemin</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 n’est pas un fichier</translation>
    </message>
    <message>
        <source>the image file %1 has %2 MB; at most 64 MB are possible</source>
        <translation>le fichier image %1 fait %2 Mo ; au plus 64 Mo sont possibles</translation>
    </message>
    <message>
        <source>the image file %1 cannot be read: %2</source>
        <translation>le fichier image %1 ne peut pas être lu : %2</translation>
    </message>
    <message>
        <source>is not a data:…;base64,… URL</source>
        <translation>n’est pas une URL de la forme « data:…;base64,… »</translation>
    </message>
    <message>
        <source>the image is too large; at most 64 MB are possible</source>
        <translation>l’image est trop grande ; au plus 64 Mo sont possibles</translation>
    </message>
    <message>
        <source>the base64 data of the image are damaged</source>
        <translation>les données base64 de l’image sont endommagées</translation>
    </message>
    <message>
        <source>has more than 2 GB; that is more than can be opened</source>
        <translation>dépasse 2 Go ; c’est plus que ce qui peut être ouvert</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>n’a pas pu être lu : %1</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Tableau Suffuse</translation>
    </message>
    <message>
        <source>Suffuse text form</source>
        <translation>Forme textuelle Suffuse</translation>
    </message>
    <message>
        <source>Ink recording (CSV)</source>
        <translation>Enregistrement d’encre (CSV)</translation>
    </message>
    <message>
        <source>Universal Ink</source>
        <translation>Universal Ink</translation>
    </message>
    <message>
        <source>Excalidraw drawing</source>
        <translation>Dessin Excalidraw</translation>
    </message>
    <message>
        <source>MyPaint events</source>
        <translation>Événements MyPaint</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>Format inconnu</translation>
    </message>
    <message>
        <source>there is no such file: %1</source>
        <translation>ce fichier n’existe pas : %1</translation>
    </message>
    <message>
        <source>is a folder; give a file inside it</source>
        <translation>est un dossier ; donnez un fichier de ce dossier</translation>
    </message>
    <message>
        <source>could not be opened: %1; check its permissions</source>
        <translation>n’a pas pu être ouvert : %1 ; vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>the ending is neither .suffuse nor .json; choose one of them</source>
        <translation>l’extension n’est ni .suffuse ni .json ; choisissez l’une d’elles</translation>
    </message>
    <message>
        <source>%1: has less than 2 numbers</source>
        <translation>%1 : a moins de 2 nombres</translation>
    </message>
    <message>
        <source>holds no freedraw elements; only those become strokes</source>
        <translation>ne contient pas d’éléments freedraw ; seuls ceux-ci deviennent des traits</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>n’est pas un objet JSON</translation>
    </message>
    <message>
        <source>: is not a list of numbers</source>
        <translation> : n’est pas une liste de nombres</translation>
    </message>
    <message>
        <source>%1[%2]: is not a number within ±1e15</source>
        <translation>%1[%2] : n’est pas un nombre dans ±1e15</translation>
    </message>
    <message>
        <source>line %1, column %2: “%3” is not a number within ±1e15</source>
        <translation>ligne %1, colonne %2 : « %3 » n’est pas un nombre dans ±1e15</translation>
    </message>
    <message>
        <source>is empty; there is nothing to paint</source>
        <translation>est vide ; il n’y a rien à peindre</translation>
    </message>
    <message>
        <source>line %1: no columns x and y; name the columns x, y, time and pressure</source>
        <translation>ligne %1 : pas de colonnes x et y ; nommez les colonnes x, y, time et pressure</translation>
    </message>
    <message>
        <source>%1: splineX has %2 numbers, splineY %3</source>
        <translation>%1 : splineX a %2 nombres, splineY %3</translation>
    </message>
    <message>
        <source>an object {…}</source>
        <translation>un objet {…}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>une liste […]</translation>
    </message>
    <message>
        <source>the file ends here, “%1” is missing; it is probably cut off</source>
        <translation>le fichier finit ici, il manque « %1 » ; il est probablement coupé</translation>
    </message>
    <message>
        <source>expected “,” or “%1” before “%2”</source>
        <translation>attendu : « , » ou « %1 » avant « %2 »</translation>
    </message>
    <message>
        <source>expected a member&apos;s name in quotes before “%1”</source>
        <translation>attendu : un nom de membre entre guillemets avant « %1 »</translation>
    </message>
    <message>
        <source>expected “:” after “%1”</source>
        <translation>attendu : « : » après « %1 »</translation>
    </message>
    <message>
        <source>is given twice; keep one of them</source>
        <translation>est indiqué deux fois ; gardez-en un seul</translation>
    </message>
    <message>
        <source>is not a member of this format; correct or remove it</source>
        <translation>n’est pas un membre de ce format ; corrigez-le ou supprimez-le</translation>
    </message>
    <message>
        <source>a string has a wrong escape “\%1”</source>
        <translation>une chaîne a un échappement incorrect « \%1 »</translation>
    </message>
    <message>
        <source>the file ends inside a string; it is probably cut off</source>
        <translation>le fichier finit à l’intérieur d’une chaîne ; il est probablement coupé</translation>
    </message>
    <message>
        <source>a string has a control character; write it as an escape such as \n</source>
        <translation>une chaîne a un caractère de contrôle ; écrivez-le en séquence d’échappement, comme \n</translation>
    </message>
    <message>
        <source>the file ends here; it is probably cut off</source>
        <translation>le fichier finit ici ; il est probablement coupé</translation>
    </message>
    <message>
        <source>expected %1 before “%2”</source>
        <translation>attendu : %1 avant « %2 »</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 n’est pas %2</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>a %1 nombres au lieu de %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>%1 is too large; the largest number is %2</source>
        <translation>%1 est trop grand ; le plus grand nombre est %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^64 − 1</source>
        <translation>%1 n’est pas un nombre entier de 0 à 2^64 − 1</translation>
    </message>
    <message>
        <source>%1 s is not in [-1e12, 1e12]</source>
        <translation>%1 s n’est pas dans [-1e12, 1e12]</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>une chaîne entre guillemets</translation>
    </message>
    <message>
        <source>is not UTF-8; save the file in that encoding</source>
        <translation>n’est pas de l’UTF-8 ; enregistrez le fichier dans ce codage</translation>
    </message>
    <message>
        <source>“%1” follows after the end of the painting; remove it</source>
        <translation>« %1 » suit après la fin du tableau ; supprimez-le</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>ligne %1, colonne %2 : %3</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>entrée standard</translation>
    </message>
    <message>
        <source>holds no pen strokes; there is nothing to paint</source>
        <translation>ne contient pas de traits de stylet ; il n’y a rien à peindre</translation>
    </message>
    <message>
        <source>the strokes span %1 × %2 units; at most 1e6 are possible, scale them down</source>
        <translation>les traits s’étendent sur %1 × %2 unités ; au plus 1e6 sont possibles, réduisez-les</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>a value has the wrong type</source>
        <translation>une valeur est d’un mauvais type</translation>
    </message>
    <message>
        <source>the first chunk must be HEAD</source>
        <translation>le premier bloc doit être HEAD</translation>
    </message>
    <message>
        <source>there is more than one HEAD</source>
        <translation>il y a plus d’un HEAD</translation>
    </message>
    <message>
        <source>there is more than one</source>
        <translation>il y en a plus d’un</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse</source>
        <translation>le bloc %1 à l’octet %2 est inconnu, et le tableau en a besoin ; mettez Suffuse à jour</translation>
    </message>
    <message>
        <source>is not a CBOR map</source>
        <translation>n’est pas une table CBOR</translation>
    </message>
    <message>
        <source>lacks the version or the counts</source>
        <translation>n’indique pas la version ou les nombres</translation>
    </message>
    <message>
        <source>was written by a newer program (%1): it needs a reader of version %2, this one is %3; update Suffuse</source>
        <translation>a été écrit par un programme plus récent (%1) : il faut un lecteur de version %2, celui-ci est en %3 ; mettez Suffuse à jour</translation>
    </message>
    <message>
        <source>the chunk DOCU is missing; the file is damaged, take a backup copy</source>
        <translation>le bloc DOCU manque ; le fichier est endommagé, utilisez une copie de sauvegarde</translation>
    </message>
    <message>
        <source>should hold %1 strokes and %2 segments, but holds %3 and %4; the file is damaged, take a backup copy</source>
        <translation>devrait contenir %1 traits et %2 segments, mais en contient %3 et %4 ; le fichier est endommagé, utilisez une copie de sauvegarde</translation>
    </message>
    <message>
        <source>the file is damaged, take a backup copy</source>
        <translation>le fichier est endommagé, utilisez une copie de sauvegarde</translation>
    </message>
    <message>
        <source>is not a .suffuse file</source>
        <translation>n’est pas un fichier .suffuse</translation>
    </message>
    <message>
        <source>the hash of the whole differs</source>
        <translation>l’empreinte de l’ensemble diffère</translation>
    </message>
    <message>
        <source>%1 bytes follow after the end</source>
        <translation>%1 octets suivent après la fin</translation>
    </message>
    <message>
        <source>has %1 bytes, but the file only %2 more</source>
        <translation>a %1 octets, mais le fichier n’en a plus que %2</translation>
    </message>
    <message>
        <source>checksum differs</source>
        <translation>la somme de contrôle diffère</translation>
    </message>
    <message>
        <source>%1 strokes and %2 segments are more than the file can hold</source>
        <translation>%1 traits et %2 segments sont plus que ce que le fichier peut contenir</translation>
    </message>
    <message>
        <source>its columns are not what the format allows</source>
        <translation>ses colonnes ne sont pas conformes au format</translation>
    </message>
    <message>
        <source>stroke %1 of it is not what the format allows</source>
        <translation>son trait %1 n’est pas conforme au format</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>“%1” is none of: %2</source>
        <translation>« %1 » ne figure pas parmi : %2</translation>
    </message>
    <message>
        <source>has %1 numbers; the kind %2 has %3</source>
        <translation>a %1 nombres ; le type %2 en a %3</translation>
    </message>
    <message>
        <source>belongs to the mode beta; remove it or change the mode</source>
        <translation>appartient au mode beta ; supprimez-le ou changez le mode</translation>
    </message>
    <message>
        <source>has %1 points instead of 4</source>
        <translation>a %1 points au lieu de 4</translation>
    </message>
    <message>
        <source>has %1 numbers instead of 2</source>
        <translation>a %1 nombres au lieu de 2</translation>
    </message>
    <message>
        <source>0 is not an id; count from 1 or leave it out</source>
        <translation>0 n’est pas un identifiant ; comptez à partir de 1 ou omettez-le</translation>
    </message>
    <message>
        <source>%1 is not in [0, 4294967295]</source>
        <translation>%1 n’est pas dans [0, 4294967295]</translation>
    </message>
    <message>
        <source>width and height must not be negative</source>
        <translation>largeur et hauteur ne doivent pas être négatives</translation>
    </message>
    <message>
        <source>%1 is not in [0, 1]</source>
        <translation>%1 n’est pas dans [0, 1]</translation>
    </message>
    <message>
        <source>“%1” is not “suffuse-text”</source>
        <translation>« %1 » n’est pas « suffuse-text »</translation>
    </message>
    <message>
        <source>0 is not a version; write 1</source>
        <translation>0 n’est pas une version ; écrivez 1</translation>
    </message>
    <message>
        <source>%1 is not a version that this program reads; it reads 1</source>
        <translation>%1 n’est pas une version que ce programme lit ; il lit 1</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input; keep one of them</source>
        <translation>une autre courbe a la même grandeur et la même entrée ; gardez-en une seule</translation>
    </message>
    <message>
        <source>needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>demande de 2 à 16 points [x, y] dans [0, 1], de gauche à droite</translation>
    </message>
    <message>
        <source>could not be opened: %1</source>
        <translation>n’a pas pu être ouvert : %1</translation>
    </message>
    <message>
        <source>has more than 1 MB; it is not a brush</source>
        <translation>dépasse 1 Mo ; ce n’est pas un pinceau</translation>
    </message>
    <message>
        <source>a colour has three numbers: red, green, blue</source>
        <translation>une couleur a trois nombres : rouge, vert, bleu</translation>
    </message>
    <message>
        <source>“%1” is not a number from 0 to 255</source>
        <translation>« %1 » n’est pas un nombre de 0 à 255</translation>
    </message>
    <message>
        <source>is larger than 1 MiB; a palette is not</source>
        <translation>dépasse 1 Mio ; une palette non</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1 : %2</translation>
    </message>
    <message>
        <source>“GIMP Palette” is missing: this is no GIMP palette</source>
        <translation>« GIMP Palette » manque : ce n’est pas une palette GIMP</translation>
    </message>
    <message>
        <source>there are more than %1 colours</source>
        <translation>il y a plus de %1 couleurs</translation>
    </message>
    <message>
        <source>has no settings; it is not a brush</source>
        <translation>n’a pas de réglages ; ce n’est pas un pinceau</translation>
    </message>
    <message>
        <source>is write-protected; save under another name or change its permissions</source>
        <translation>est protégé en écriture ; enregistrez sous un autre nom ou modifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>belongs to %1, and would not any more; save under another name</source>
        <translation>appartient à %1, et ne lui appartiendrait plus ; enregistrez sous un autre nom</translation>
    </message>
    <message>
        <source>could not be brought to the disk</source>
        <translation>n’a pas pu être transmis au disque</translation>
    </message>
    <message>
        <source>the backup could not be made; check the folder</source>
        <translation>la sauvegarde n’a pas pu être faite ; vérifiez le dossier</translation>
    </message>
    <message>
        <source>the first element is not curve_set</source>
        <translation>le premier élément n’est pas curve_set</translation>
    </message>
    <message>
        <source>%1 of %2 is &quot;%3&quot;, not a number up to 1e6</source>
        <translation>%1 de %2 est « %3 », pas un nombre jusqu’à 1e6</translation>
    </message>
    <message>
        <source>a curve has %1 control points; 3n + 1 make cubics</source>
        <translation>une courbe a %1 points de contrôle ; 3n + 1 font des cubiques</translation>
    </message>
    <message>
        <source>a curve has no colours on one of its sides</source>
        <translation>une courbe n’a pas de couleurs d’un de ses côtés</translation>
    </message>
    <message>
        <source>has more than 64 MB of XML; that is more than is read</source>
        <translation>a plus de 64 Mo de XML ; c’est plus que ce qui est lu</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to paint</source>
        <translation>ne contient pas de courbes ; il n’y a rien à peindre</translation>
    </message>
    <message>
        <source>Diffusion curves (XML)</source>
        <translation>Courbes de diffusion (XML)</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>il est endommagé</translation>
    </message>
    <message>
        <source>it belongs to another painting</source>
        <translation>il appartient à un autre tableau</translation>
    </message>
    <message>
        <source>it has too many steps</source>
        <translation>il a trop d’étapes</translation>
    </message>
    <message>
        <source>step %1 is damaged</source>
        <translation>l’étape %1 est endommagée</translation>
    </message>
    <message>
        <source>step %1 does not fit the painting</source>
        <translation>l’étape %1 ne correspond pas au tableau</translation>
    </message>
    <message>
        <source>the undo history was left out: %1</source>
        <translation>l’historique d’annulation a été omis : %1</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2: %3</source>
        <translation>bloc %1 à l’octet %2 : %3</translation>
    </message>
    <message>
        <source>is cut off after %1 bytes</source>
        <translation>est coupé après %1 octets</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>octet %1 : %2</translation>
    </message>
    <message>
        <source>is damaged, and nothing in it is whole (%1); take a backup copy</source>
        <translation>est endommagé, et rien n’y est intact (%1) ; utilisez une copie de sauvegarde</translation>
    </message>
    <message>
        <source>the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one</source>
        <translation>canevas, papier, groupes, nuances et modèle manquent ; le canevas est celui par défaut</translation>
    </message>
    <message>
        <source>the image of the paper is missing; there is no paper now</source>
        <translation>l’image du papier manque ; il n’y a maintenant pas de papier</translation>
    </message>
    <message>
        <source>the underlay is missing</source>
        <translation>le modèle manque</translation>
    </message>
    <message>
        <source>%1 strokes with %2 segments are here; how many there were is not known</source>
        <translation>%1 traits avec %2 segments sont là ; on ne sait pas combien il y en avait</translation>
    </message>
    <message>
        <source>%1 of %2 strokes are missing, with %3 of %4 segments</source>
        <translation>%1 traits sur %2 manquent, avec %3 segments sur %4</translation>
    </message>
    <message>
        <source>all %1 strokes are here</source>
        <translation>les %1 traits sont tous là</translation>
    </message>
    <message>
        <source>%1 strokes are in no group any more</source>
        <translation>%1 traits ne sont plus dans aucun groupe</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>la fin du fichier manque</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>le journal ne peut pas être écrit (%1)</translation>
    </message>
    <message>
        <source>is not a journal of Suffuse</source>
        <translation>n’est pas un journal de Suffuse</translation>
    </message>
    <message>
        <source>ends before its first painting was written</source>
        <translation>finit avant que son premier tableau ait été écrit</translation>
    </message>
    <message>
        <source>was written by a newer program (%1); update Suffuse</source>
        <translation>a été écrit par un programme plus récent (%1) ; mettez Suffuse à jour</translation>
    </message>
    <message>
        <source>Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)</source>
        <translation>Suffuse lit .suffuse, sa forme textuelle (.json), l’encre en CSV, Universal Ink, InkML, Excalidraw, les événements MyPaint, Xournal++, Rnote, SVG et les courbes de diffusion (XML)</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>Dessin SVG</translation>
    </message>
    <message>
        <source>the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down</source>
        <translation>le dessin mesure %1 × %2 unités ; au plus 1e6 sont possibles, réduisez-le</translation>
    </message>
    <message>
        <source>holds no paths that can be painted; in the program that drew it, turn text and images into paths first</source>
        <translation>ne contient pas de chemins que l’on puisse peindre ; dans le programme qui l’a dessiné, convertissez d’abord textes et images en chemins</translation>
    </message>
    <message>
        <source>the preview</source>
        <translation>l’aperçu</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>la dernière vue</translation>
    </message>
    <message>
        <source>the undo history</source>
        <translation>l’historique d’annulation</translation>
    </message>
    <message>
        <source>the end of the file is damaged</source>
        <translation>la fin du fichier est endommagée</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at byte %1</source>
        <translation>le fichier est endommagé ou coupé à l’octet %1</translation>
    </message>
    <message>
        <source>Damaged and left out: %1. All %2 strokes are here.</source>
        <translation>Endommagé et omis : %1. Les %2 traits sont tous là.</translation>
    </message>
    <message>
        <source>damaged and left out: %1</source>
        <translation>endommagé et omis : %1</translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>%n élément non dessiné à main levée</numerusform>
            <numerusform>%n éléments non dessinés à main levée</numerusform>
        </translation>
    </message>
    <message>
        <source>column “%1”</source>
        <translation>colonne « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>%n forme de pinceau</numerusform>
            <numerusform>%n formes de pinceau</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>%n pointe de pinceau tournée ou étirée</numerusform>
            <numerusform>%n pointes de pinceau tournées ou étirées</numerusform>
        </translation>
    </message>
    <message>
        <source>the pen&apos;s azimuths</source>
        <translation>les azimuts du stylet</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>%n vue de texte reconnu</numerusform>
            <numerusform>%n vues de texte reconnu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>Omis : %1.</numerusform>
            <numerusform>Omis : %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>list</comment>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>%n dégradé</numerusform>
            <numerusform>%n dégradés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>%n motif</numerusform>
            <numerusform>%n motifs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>%n chemin de découpe</numerusform>
            <numerusform>%n chemins de découpe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>%n masque</numerusform>
            <numerusform>%n masques</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>%n filtre</numerusform>
            <numerusform>%n filtres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>%n mode de fusion</numerusform>
            <numerusform>%n modes de fusion</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n marqueur</numerusform>
            <numerusform>%n marqueurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>%n contour enchevêtré</numerusform>
            <numerusform>%n contours enchevêtrés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n texte</numerusform>
            <numerusform>%n textes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>%n règle de style</numerusform>
            <numerusform>%n règles de style</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>%n &lt;use&gt; de lui-même</numerusform>
            <numerusform>%n &lt;use&gt; d’eux-mêmes</numerusform>
        </translation>
    </message>
    <message>
        <source>There is more in the drawing than is read; the rest was left out.</source>
        <translation>Le dessin contient plus que ce qui est lu ; le reste a été omis.</translation>
    </message>
    <message>
        <source>ends after %1 bytes</source>
        <translation>finit après %1 octets</translation>
    </message>
    <message>
        <source>its line endings were changed on the way, transfer it as a binary file</source>
        <translation>ses fins de ligne ont été changées en chemin, transférez-le comme fichier binaire</translation>
    </message>
    <message>
        <source>its first bytes are damaged</source>
        <translation>ses premiers octets sont endommagés</translation>
    </message>
    <message>
        <source>the first bytes of the file</source>
        <translation>les premiers octets du fichier</translation>
    </message>
    <message>
        <source>version: %1 does not know all that strokes have here; write %2</source>
        <translation>version : %1 ne connaît pas tout ce que les traits ont ici ; écrivez %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads up to version %2; update Suffuse</source>
        <translation>%1 est plus récent que ce programme, qui lit jusqu’à la version %2 ; mettez Suffuse à jour</translation>
    </message>
    <message>
        <source>This file is empty: nothing was saved in it.</source>
        <translation>Ce fichier est vide : rien n’y a été enregistré.</translation>
    </message>
    <message>
        <source>This is UTF-16 text. Save it as UTF-8.</source>
        <translation>C’est du texte UTF-16. Enregistrez-le en UTF-8.</translation>
    </message>
    <message>
        <source>This is a picture, not a painting. %1.</source>
        <translation>C’est une image, pas un tableau. %1.</translation>
    </message>
    <message>
        <source>This is neither a painting nor a recording that can be read. %1. Other programs can export SVG.</source>
        <translation>Ce n’est ni un tableau ni un enregistrement lisible. %1. D’autres programmes peuvent exporter en SVG.</translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>%n remplissage</numerusform>
            <numerusform>%n remplissages</numerusform>
        </translation>
    </message>
    <message>
        <source>Other fonts stand in for those that are not installed: %1.</source>
        <translation>D’autres polices remplacent celles qui ne sont pas installées : %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>%n texte est arrivé sous forme de lettres : il n’est plus modifiable comme texte.</numerusform>
            <numerusform>%n textes sont arrivés sous forme de lettres : ils ne sont plus modifiables comme textes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>l’image de %n calque d’image manque</numerusform>
            <numerusform>les images de %n calques d’image manquent</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: it has no list of its parts.</source>
        <translation>Ce fichier OpenRaster est endommagé : il n’a pas de liste de ses parties.</translation>
    </message>
    <message>
        <source>OpenRaster picture</source>
        <translation>Image OpenRaster</translation>
    </message>
    <message>
        <source>Another program changed this picture. What was opened is the painting as Suffuse exported it.</source>
        <translation>Un autre programme a modifié cette image. Ce qui a été ouvert est le tableau tel que Suffuse l’a exporté.</translation>
    </message>
    <message>
        <source>The linked picture %1 is missing, and is not seen: put its file back, or link another one in the Inspector.</source>
        <translation>L’image liée %1 manque, et n’est pas affichée : remettez son fichier, ou liez-en une autre dans l’inspecteur.</translation>
    </message>
    <message>
        <source>The linked picture %1 has more than 64 MB, and is not seen.</source>
        <translation>L’image liée %1 dépasse 64 Mo, et n’est pas affichée.</translation>
    </message>
    <message>
        <source>The linked picture %1 has changed since it was linked, and is not seen: link it anew in the Inspector.</source>
        <translation>L’image liée %1 a changé depuis qu’elle a été liée, et n’est pas affichée : liez-la de nouveau dans l’inspecteur.</translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>De même pour %n autre image.</numerusform>
            <numerusform>De même pour %n autres images.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file is compressed with gzip, and what is in it is neither an SVG nor a notebook of Xournal++ or Rnote. Unpack it first. %1.</source>
        <translation>Ce fichier est compressé avec gzip, et ce qu’il contient n’est ni un SVG ni un carnet de Xournal++ ou de Rnote. Décompressez-le d’abord. %1.</translation>
    </message>
    <message>
        <source>Another program has changed the drawing since Suffuse wrote it. It is opened as it is drawn now, not as the painting that is in it.</source>
        <translation>Un autre programme a modifié le dessin depuis que Suffuse l’a écrit. Il est ouvert tel qu’il est dessiné maintenant, et non comme le tableau qu’il contient.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>la mémoire est insuffisante</translation>
    </message>
    <message>
        <source>is too large once it is unpacked</source>
        <translation>est trop grand une fois décompressé</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>est endommagé : décompression impossible</translation>
    </message>
    <message>
        <source>the colour profile</source>
        <translation>le profil de couleur</translation>
    </message>
    <message>
        <source>the size on paper</source>
        <translation>la taille sur papier</translation>
    </message>
    <message>
        <source>the first element is not xournal</source>
        <translation>le premier élément n’est pas xournal</translation>
    </message>
    <message>
        <source>holds no pages</source>
        <translation>ne contient pas de pages</translation>
    </message>
    <message>
        <source>%1 is no number within ±1e7</source>
        <translation>%1 n’est pas un nombre dans ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 layers</source>
        <translation>a plus de %1 calques</translation>
    </message>
    <message>
        <source>the page has no size</source>
        <translation>la page n’a pas de taille</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Calque %1</translation>
    </message>
    <message>
        <source>the stroke has an x without y</source>
        <translation>le trait a un x sans y</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>a plus de %1 points</translation>
    </message>
    <message>
        <source>the stroke has no width</source>
        <translation>le trait n’a pas de largeur</translation>
    </message>
    <message>
        <source>%1: %2 is no number within ±1e7</source>
        <translation>%1 : %2 n’est pas un nombre dans ±1e7</translation>
    </message>
    <message>
        <source>Xournal++ notebook</source>
        <translation>Carnet Xournal++</translation>
    </message>
    <message>
        <source>InkML recording</source>
        <translation>Enregistrement InkML</translation>
    </message>
    <message>
        <source>Rnote notebook</source>
        <translation>Carnet Rnote</translation>
    </message>
    <message>
        <source>the first element is not ink</source>
        <translation>le premier élément n’est pas ink</translation>
    </message>
    <message>
        <source>its groups are too deep</source>
        <translation>ses groupes sont imbriqués trop profondément</translation>
    </message>
    <message>
        <source>a point has more than %1 values</source>
        <translation>un point a plus de %1 valeurs</translation>
    </message>
    <message>
        <source>the trace is not a list of points with %1 numbers each, or there are more than %2 points</source>
        <translation>le tracé n’est pas une liste de points à %1 nombres chacun, ou il y a plus de %2 points</translation>
    </message>
    <message>
        <source>the trace has no X and Y</source>
        <translation>le tracé n’a pas de X et Y</translation>
    </message>
    <message>
        <source>a point is farther than 1e7 units away</source>
        <translation>un point est à plus de 1e7 unités</translation>
    </message>
    <message>
        <source>holds no notebook that can be read; save it with Rnote 0.5 or later</source>
        <translation>ne contient pas de carnet lisible ; enregistrez-le avec Rnote 0.5 ou une version ultérieure</translation>
    </message>
    <message>
        <source>a point is not two numbers within ±1e7</source>
        <translation>un point n’est pas fait de deux nombres dans ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>a plus de %1 nombres</translation>
    </message>
    <message>
        <source>is Universal Ink %1.%2; 3.0 and 3.1 can be read</source>
        <translation>est en Universal Ink %1.%2 ; 3.0 et 3.1 sont lisibles</translation>
    </message>
    <message>
        <source>is damaged: a part of it is not whole</source>
        <translation>est endommagé : une partie n’en est pas intacte</translation>
    </message>
    <message>
        <source>its part %1 is packed in a way that cannot be read</source>
        <translation>sa partie %1 est compressée d’une façon illisible</translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>%n style de ligne</numerusform>
            <numerusform>%n styles de ligne</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n forme</numerusform>
            <numerusform>%n formes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>%n trajet du stylet au-dessus du papier</numerusform>
            <numerusform>%n trajets du stylet au-dessus du papier</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>%n conversion de canaux</numerusform>
            <numerusform>%n conversions de canaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>%n enregistrement sonore</numerusform>
            <numerusform>%n enregistrements sonores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>%n papier ligné ou imprimé</numerusform>
            <numerusform>%n papiers lignés ou imprimés</numerusform>
        </translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone</source>
        <translation>un composant de Suffuse, %1, %2 ; réinstallez Suffuse. Il ne sert qu’aux fichiers PDF</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>ne peut pas être chargé (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>est d’une autre version de Suffuse</translation>
    </message>
    <message>
        <source>would have more than 2 GB</source>
        <translation>dépasserait 2 Go</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>n’a pas pu être écrit : %1</translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>Du seul tableau (%n) de ce fichier PDF, le premier a été ouvert.</numerusform>
            <numerusform>Des %n tableaux de ce fichier PDF, le premier a été ouvert.</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>Fichier PDF</translation>
    </message>
    <message>
        <source>This is a PDF file, and %1.</source>
        <translation>C’est un fichier PDF, et %1.</translation>
    </message>
    <message>
        <source>This PDF file is damaged: %1.</source>
        <translation>Ce fichier PDF est endommagé : %1.</translation>
    </message>
    <message>
        <source>This PDF file holds no painting. Suffuse opens those that it wrote; open a picture of its pages as a layer instead.</source>
        <translation>Ce fichier PDF ne contient pas de tableau. Suffuse ouvre ceux qu’il a écrits ; ouvrez plutôt une image de ses pages comme calque.</translation>
    </message>
    <message>
        <source>Another program changed this PDF file. What was opened is the painting as Suffuse exported it.</source>
        <translation>Un autre programme a modifié ce fichier PDF. Ce qui a été ouvert est le tableau tel que Suffuse l’a exporté.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupCells</name>
    <message>
        <source>Clipped to what lies below it in its group</source>
        <translation>Écrêté par ce qui est dessous dans son groupe</translation>
    </message>
    <message>
        <source>A mask for the others in its group</source>
        <translation>Un masque pour les autres éléments de son groupe</translation>
    </message>
    <message>
        <source>A wash: its strokes are one</source>
        <translation>Un lavis : ses traits ne font qu’un</translation>
    </message>
    <message>
        <source>Shown alone</source>
        <translation>Montré seul</translation>
    </message>
    <message>
        <source>A draft: left out of what is exported</source>
        <translation>Une ébauche : omise de ce qui est exporté</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupHand</name>
    <message>
        <source>The group is locked: nothing changes.</source>
        <translation>Le groupe est verrouillé : rien ne change.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Changer l’opacité du groupe</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Changer le mode du groupe</translation>
    </message>
    <message>
        <source>Opacity of the group</source>
        <translation>Opacité du groupe</translation>
    </message>
</context>
<context>
    <name>suffuse::HintLabel</name>
    <message>
        <source>Hint</source>
        <translation>Conseil</translation>
    </message>
</context>
<context>
    <name>suffuse::HistoryPanel</name>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Every change since the painting was opened. Click one to go back or forward to it.</source>
        <translation>Toutes les modifications depuis l’ouverture du tableau. Cliquez sur l’une d’elles pour y revenir ou y avancer.</translation>
    </message>
    <message>
        <source>This stroke</source>
        <translation>Ce trait</translation>
    </message>
</context>
<context>
    <name>suffuse::Importing</name>
    <message>
        <source>Picture to Strokes</source>
        <translation>Image en traits</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Importer un modèle</translation>
    </message>
    <message>
        <source>Import Strokes</source>
        <translation>Importer des traits</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was imported.</source>
        <translation>« %1 » est endommagé. Ce qui en est intact a été importé.</translation>
    </message>
    <message>
        <source>Import picture as layer</source>
        <translation>Importer une image comme calque</translation>
    </message>
    <message>
        <source>Add as &amp;Layer</source>
        <translation>Ajouter comme &amp;calque</translation>
    </message>
    <message>
        <source>Use as &amp;Underlay</source>
        <translation>Utiliser comme &amp;modèle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message>
        <source>Nothing is selected. Click a stroke to see and change its values.</source>
        <translation>Rien n’est sélectionné. Cliquez sur un trait pour voir et changer ses valeurs.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke…</source>
        <translation>Le long du trait…</translation>
    </message>
    <message>
        <source>Sets a value along the stroke: constant, as a ramp, or drawn as a curve.</source>
        <translation>Règle une valeur le long du trait : constante, en rampe ou dessinée en courbe.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%1 de %Ln segment</numerusform>
            <numerusform>%1 de %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>%Ln segment qui efface</numerusform>
            <numerusform>%Ln segments qui effacent</numerusform>
        </translation>
    </message>
    <message>
        <source>They make paint paler.</source>
        <translation>Ils rendent la peinture plus pâle.</translation>
    </message>
    <message>
        <source>They take paint away: the more density, the more.</source>
        <translation>Ils enlèvent de la peinture : plus il y a de densité, plus ils en enlèvent.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>%Ln d’entre eux enlève de la peinture.</numerusform>
            <numerusform>%Ln d’entre eux enlèvent de la peinture.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KeyboardFocus</name>
    <message>
        <source>The %1 dock has the keyboard; Esc gives it back to the canvas.</source>
        <translation>Le panneau %1 reçoit le clavier ; Échap le rend au canevas.</translation>
    </message>
    <message>
        <source>The canvas has the keyboard.</source>
        <translation>Le canevas reçoit le clavier.</translation>
    </message>
    <message>
        <source>The tool bar “%1” has the keyboard; Esc gives it back to the canvas.</source>
        <translation>La barre d’outils « %1 » reçoit le clavier ; Échap le rend au canevas.</translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message>
        <source>Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.</source>
        <translation>Tracer une ligne pour insérer des nœuds là où elle croise des traits. Maj : couper les traits en deux. Ctrl : pas de 15°.</translation>
    </message>
    <message>
        <source>Cut strokes</source>
        <translation>Couper les traits</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insérer des nœuds</translation>
    </message>
    <message>
        <source>%1 cut into %2</source>
        <extracomment>what the knife did; %1: &quot;2 strokes&quot;, %2: &quot;5 parts&quot;</extracomment>
        <translation>%1 en %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait coupé</numerusform>
            <numerusform>%Ln traits coupés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln partie</numerusform>
            <numerusform>%Ln parties</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inserted in %2</source>
        <extracomment>what the knife did; %1: &quot;3 nodes&quot;, %2: &quot;2 strokes&quot;</extracomment>
        <translation>%1 dans %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>%Ln nœud inséré</numerusform>
            <numerusform>%Ln nœuds insérés</numerusform>
        </translation>
    </message>
    <message>
        <source>There are nodes already where the line crosses strokes.</source>
        <translation>Il y a déjà des nœuds là où la ligne croise des traits.</translation>
    </message>
    <message>
        <source>The line crosses no stroke.</source>
        <translation>La ligne ne croise aucun trait.</translation>
    </message>
    <message>
        <source>The line crosses no selected stroke.</source>
        <translation>La ligne ne croise aucun trait sélectionné.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>A fill is cut only where the line goes all the way through it.</source>
        <translation>Un remplissage n’est coupé que là où la ligne le traverse de part en part.</translation>
    </message>
    <message>
        <source>Inserts nodes where a line crosses strokes; with Shift it cuts them apart there.</source>
        <translation>Insère des nœuds là où une ligne croise des traits ; avec Maj, elle les y coupe en deux.</translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message>
        <source>Tool Options</source>
        <translation>Options de l’outil</translation>
    </message>
</context>
<context>
    <name>suffuse::MixingSection</name>
    <message>
        <source>Mixing</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>Paint colours over each other here. Shift+drag rubs, Ctrl+click picks.</source>
        <translation>Superposez ici des couleurs. Maj+glisser frotte, Ctrl+clic prélève.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Paints with the current colour.</source>
        <translation>Peint avec la couleur actuelle.</translation>
    </message>
    <message>
        <source>Rub</source>
        <translation>Frotter</translation>
    </message>
    <message>
        <source>Carries the paint under the pointer along.</source>
        <translation>Entraîne la peinture sous le pointeur.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Prélever</translation>
    </message>
    <message>
        <source>Makes the colour under the pointer the current one.</source>
        <translation>Fait de la couleur sous le pointeur la couleur actuelle.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Prend une feuille vierge.</translation>
    </message>
</context>
<context>
    <name>suffuse::MomentRow</name>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>All dried</source>
        <translation>Tout sec</translation>
    </message>
    <message>
        <source>As it looks now</source>
        <translation>Comme maintenant</translation>
    </message>
    <message>
        <source>At the time</source>
        <translation>Moment choisi</translation>
    </message>
    <message>
        <source>The finished painting, the moment that the canvas shows, or any other.</source>
        <translation>Le tableau terminé, le moment que montre le canevas, ou n’importe quel autre.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Minutes and seconds, as the timeline shows them: 1:02.345</source>
        <translation>Minutes et secondes, comme les montre la chronologie : 1:02.345</translation>
    </message>
</context>
<context>
    <name>suffuse::NewDialog</name>
    <message>
        <source>Custom</source>
        <translation>Personnalisée</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Échanger largeur et hauteur</translation>
    </message>
    <message>
        <source>C&amp;reate</source>
        <translation>C&amp;réer</translation>
    </message>
    <message>
        <source>New Painting</source>
        <translation>Nouveau tableau</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>Usual sizes, and sheets with a ground of their own</source>
        <translation>Tailles usuelles, et feuilles avec leur propre fond</translation>
    </message>
    <message>
        <source>Sides in</source>
        <translation>Côtés en</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixels</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>What width and height are given in. A pixel is a unit of the canvas.</source>
        <translation>L’unité de la largeur et de la hauteur. Un pixel est une unité du canevas.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Pixels for each inch of paper. The sheet stays as large on paper.</source>
        <translation>Pixels par pouce de papier. La feuille reste aussi grande sur le papier.</translation>
    </message>
</context>
<context>
    <name>suffuse::NextNodeFields</name>
    <message>
        <source>X</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Where the next node is set, from the left. Return sets it, and so does a click</source>
        <translation>Où se place le nœud suivant, depuis la gauche. Entrée le place, tout comme un clic</translation>
    </message>
    <message>
        <source>Y</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Where the next node is set, from the top. Return sets it, and so does a click</source>
        <translation>Où se place le nœud suivant, depuis le haut. Entrée le place, tout comme un clic</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>From the last node to the next one. Return sets it, and so does a click</source>
        <translation>Du dernier nœud au suivant. Entrée le place, tout comme un clic</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a click</source>
        <translation>Direction du dernier nœud au suivant, dans le sens horaire depuis la droite. Entrée le place, tout comme un clic</translation>
    </message>
    <message>
        <source>Close</source>
        <extracomment>closes an outline</extracomment>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Closes the outline at its first node (Shift+Return)</source>
        <translation>Ferme le contour à son premier nœud (Maj+Entrée)</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeCommands</name>
    <message>
        <source>The joined stroke has the upper one&apos;s fill. Undo brings the other back.</source>
        <translation>Le trait joint a le remplissage du trait supérieur. Annuler restaure l’autre.</translation>
    </message>
    <message>
        <source>The joined stroke has no fill, as the upper one had none. Undo brings the lower one&apos;s back.</source>
        <translation>Le trait joint n’a pas de remplissage, le trait supérieur n’en ayant pas. Annuler restaure celui du trait inférieur.</translation>
    </message>
    <message>
        <source>Smooth nodes</source>
        <translation>Lisser les nœuds</translation>
    </message>
    <message>
        <source>Symmetric nodes</source>
        <translation>Rendre les nœuds symétriques</translation>
    </message>
    <message>
        <source>Corner nodes</source>
        <translation>Rendre les nœuds anguleux</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insérer des nœuds</translation>
    </message>
    <message>
        <source>Break stroke</source>
        <translation>Briser le trait</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Joindre les nœuds</translation>
    </message>
    <message>
        <source>Reverse strokes</source>
        <translation>Inverser les traits</translation>
    </message>
    <message>
        <source>Delete nodes</source>
        <translation>Supprimer les nœuds</translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Supprimer les segments</translation>
    </message>
    <message>
        <source>Bridge segments</source>
        <translation>Relier les segments</translation>
    </message>
    <message>
        <source>A node alone has no paint: select the nodes at both ends of a segment, or take the whole stroke with the Select tool.</source>
        <translation>Un nœud seul n’a pas de peinture : sélectionnez les nœuds aux deux bouts d’un segment, ou prenez le trait entier avec l’outil Sélection.</translation>
    </message>
    <message>
        <source>The closed outline begins and ends at this node, so it has nothing more to break. Delete Segments (Ctrl+Del) opens it.</source>
        <translation>Le contour fermé commence et finit à ce nœud : il n’a donc plus rien à briser. Supprimer les segments (Ctrl+Suppr) l’ouvre.</translation>
    </message>
    <message>
        <source>Join needs two ends of strokes: select one, and Shift+click the other or drag around both.</source>
        <translation>Pour joindre, il faut deux extrémités de traits : sélectionnez-en une, puis Maj+clic sur l’autre, ou entourez les deux.</translation>
    </message>
    <message>
        <source>These two ends cannot be joined.</source>
        <translation>Ces deux extrémités ne peuvent pas être jointes.</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeTool</name>
    <message>
        <source>Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.</source>
        <translation>Tirer la poignée pour courber. Maj : rendre le nœud anguleux. Ctrl : pas de 15°.</translation>
    </message>
    <message>
        <source>Insert node</source>
        <translation>Insérer un nœud</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>Déplacer les nœuds</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Déplacer le nœud</translation>
    </message>
    <message>
        <source>Click a segment to select it, Shift+click for a run or another stroke&apos;s, Ctrl+click to add or remove one. Drag around nodes.</source>
        <translation>Clic : sélectionner un segment ; Maj+clic : une suite ou un autre trait ; Ctrl+clic : en ajouter ou en retirer un. Glisser : entourer des nœuds.</translation>
    </message>
    <message>
        <source>Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. Shift+click for more.</source>
        <translation>Glisser : déplacer des nœuds, en douceur dans la portée (molette, Alt+glisser). Ctrl : le long d’un axe, Ctrl+Alt : la poignée. Maj+clic : d’autres.</translation>
    </message>
    <message>
        <source>Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to select the segment.</source>
        <translation>Glisser pour courber dans la portée (molette, Alt+glisser). Double-clic : insérer un nœud. Clic : sélectionner le segment.</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Déplacer l’effacement</translation>
    </message>
    <message>
        <source>Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.</source>
        <translation>Déplacer l’effacement : il enlève là où il se trouve. Ctrl : le long d’un axe. Échap abandonne.</translation>
    </message>
    <message>
        <source>Drag to move the erasure. Click to select it in all strokes, again for its part in this one, again for a segment. Delete removes it.</source>
        <translation>Glisser : déplacer l’effacement. Clic : le sélectionner dans tous les traits, puis sa partie dans celui-ci, puis un segment. Suppr l’enlève.</translation>
    </message>
    <message>
        <source>Move segments</source>
        <translation>Déplacer les segments</translation>
    </message>
    <message>
        <source>An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes the gradient away; Esc first, and Delete means the stroke.</source>
        <translation>Une extrémité de dégradé ne se supprime pas seule. Supprimer, près de Dégradé dans l’inspecteur, enlève le dégradé ; après Échap, Suppr vaut pour le trait.</translation>
    </message>
    <message>
        <source>What was selected is deleted; its strokes are merely shown. Click what else is to go, or take whole strokes with the Select tool.</source>
        <translation>La sélection est supprimée ; ses traits sont seulement montrés. Cliquez sur ce qu’il faut encore supprimer, ou prenez des traits entiers avec Sélection.</translation>
    </message>
</context>
<context>
    <name>suffuse::NumberField</name>
    <message>
        <source>“%1” is not a number. Sums such as 12*1.5 or +2 work too.</source>
        <translation>« %1 » n’est pas un nombre. Des calculs comme 12*1.5 ou +2 sont aussi possibles.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3 is possible.</source>
        <translation>%1 est hors limites : valeurs possibles de %2 à %3.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: this number has no unit.</source>
        <translation>« %1 » n’est pas possible ici : ce nombre n’a pas d’unité.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: the unit is %2.</source>
        <translation>« %1 » n’est pas possible ici : l’unité est %2.</translation>
    </message>
    <message>
        <source> u</source>
        <translation> u</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in</source>
        <translation> po</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> u²/s</source>
        <translation> u²/s</translation>
    </message>
    <message>
        <source>%1 is out of range: more than 0 and up to %2 is possible.</source>
        <translation>%1 est hors limites : plus de 0 et jusqu’à %2.</translation>
    </message>
    <message>
        <source>%1 is the most that is possible.</source>
        <translation>%1 est le maximum possible.</translation>
    </message>
    <message>
        <source>%1 is the least that is possible.</source>
        <translation>%1 est le minimum possible.</translation>
    </message>
</context>
<context>
    <name>suffuse::PanTool</name>
    <message>
        <source>Drag to move the canvas. The wheel zooms; R and drag turns.</source>
        <translation>Glisser pour déplacer le canevas. Molette : zoomer ; R+glisser : tourner.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPad</name>
    <message>
        <source>Try your pen here.</source>
        <translation>Essayez votre stylet ici.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPage</name>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Souple</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Régulière</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Ferme</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisée</translation>
    </message>
    <message>
        <source>How hard the pen must be pressed, for all brushes.</source>
        <translation>Combien il faut appuyer sur le stylet, pour tous les pinceaux.</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Prend une feuille vierge.</translation>
    </message>
    <message>
        <source>pressure of the pen →</source>
        <translation>pression du stylet →</translation>
    </message>
    <message>
        <source>↑ paints with</source>
        <translation>↑ peint avec</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>Courbe de pression</translation>
    </message>
    <message>
        <source>Drag the points; click for another; drag one out to take it away.</source>
        <translation>Tirer les points ; cliquer pour en ajouter un ; le tirer dehors pour le retirer.</translation>
    </message>
    <message>
        <source>Paint here with the brush in use; the dot on the curve is the pen&apos;s pressure.</source>
        <translation>Peignez ici avec le pinceau utilisé ; la pastille sur la courbe est la pression du stylet.</translation>
    </message>
    <message>
        <source>Only the pen and the mouse paint; fingers move the view</source>
        <translation>Seuls le stylet et la souris peignent ; les doigts déplacent la vue</translation>
    </message>
    <message>
        <source>One finger moves the canvas, two zoom and turn it. Otherwise one finger paints.</source>
        <translation>Un doigt déplace le canevas, deux zooment et le tournent. Sinon, un doigt peint.</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Vider</translation>
    </message>
</context>
<context>
    <name>suffuse::PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Format, depth, quality, resolution, size, area and moment under a name</source>
        <translation>Format, profondeur, qualité, résolution, taille, zone et moment sous un nom</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>E&amp;nregistrer…</translation>
    </message>
    <message>
        <source>Keep what is set here as a preset</source>
        <translation>Garder les réglages d’ici comme préréglage</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Forget the chosen preset</source>
        <translation>Oublier le préréglage choisi</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>There is a preset “%1”. Replace it?</source>
        <translation>Il y a un préréglage « %1 ». Le remplacer ?</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Enregistrer le préréglage</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>&amp;Imprimer</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Prints the canvas's colour; without it the paint lies on the paper as it is.</source>
        <translation>Imprime la couleur du canevas ; sans elle, la peinture est posée sur le papier tel qu’il est.</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>Imprimer dans un fichier (PDF)</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Imprimante</translation>
    </message>
    <message>
        <source>Where the page comes out</source>
        <translation>Où sort la page</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. A file can be printed elsewhere.</source>
        <translation>Aucune imprimante n’est configurée sur cet ordinateur. Un fichier peut être imprimé ailleurs.</translation>
    </message>
    <message>
        <source>The PDF file that is written: one page as large as the paper.</source>
        <translation>Le fichier PDF écrit : une page aussi grande que le papier.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copies</translation>
    </message>
    <message>
        <source>How often the page is printed</source>
        <translation>Combien de fois la page est imprimée</translation>
    </message>
    <message>
        <source>%1 – %2 × %3 mm</source>
        <translation>%1 – %2 × %3 mm</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>Aussi grand que la feuille</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Portrait</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Paysage</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>How the paper lies</source>
        <translation>Dans quel sens est le papier</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>The size of the paper</source>
        <translation>La taille du papier</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Left margin</source>
        <translation>Marge gauche</translation>
    </message>
    <message>
        <source>Top margin</source>
        <translation>Marge du haut</translation>
    </message>
    <message>
        <source>Right margin</source>
        <translation>Marge droite</translation>
    </message>
    <message>
        <source>Bottom margin</source>
        <translation>Marge du bas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>What stays empty at this edge of the paper</source>
        <translation>Ce qui reste vide à ce bord du papier</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Marges</translation>
    </message>
    <message>
        <source>Fit to the page</source>
        <translation>Ajuster à la page</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>Taille réelle</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Mise à l’échelle</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Of the actual size</source>
        <translation>Par rapport à la taille réelle</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>How large the picture lies on the paper</source>
        <translation>Quelle taille l’image a sur le papier</translation>
    </message>
    <message>
        <source>%1 dpi</source>
        <translation>%1 ppp</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>How many dots an inch the picture is drawn with</source>
        <translation>Avec combien de points par pouce l’image est dessinée</translation>
    </message>
    <message>
        <source>Usual: %1 dpi</source>
        <translation>Habituelle : %1 ppp</translation>
    </message>
    <message>
        <source>The printer's: %1 dpi</source>
        <translation>Celle de l’imprimante : %1 ppp</translation>
    </message>
    <message>
        <source>The margins leave no room on the paper.</source>
        <translation>Les marges ne laissent pas de place sur le papier.</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 mm on the paper.</source>
        <translation>L’image mesure %1 × %2 mm sur le papier.</translation>
    </message>
    <message>
        <source>What does not fit is cut off.</source>
        <translation>Ce qui ne tient pas est coupé.</translation>
    </message>
    <message>
        <source>PDF files</source>
        <translation>Fichiers PDF</translation>
    </message>
    <message>
        <source>“%1” is not there any more. Choose another printer.</source>
        <translation>« %1 » n’est plus là. Choisissez une autre imprimante.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintJob</name>
    <message>
        <source>The page does not fit into memory.</source>
        <translation>La page ne tient pas en mémoire.</translation>
    </message>
    <message>
        <source>There is no room for the page on the disk: %1</source>
        <translation>Il n’y a pas de place pour la page sur le disque : %1</translation>
    </message>
    <message>
        <source>The printer does not take the page. See whether it is there, or print to a file.</source>
        <translation>L’imprimante n’accepte pas la page. Vérifiez qu’elle est là, ou imprimez dans un fichier.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintRows</name>
    <message>
        <source>Print size</source>
        <translation>Taille imprimée</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Largeur sur papier</translation>
    </message>
    <message>
        <source>Width on paper; the height and the pixels follow.</source>
        <translation>Largeur sur papier ; la hauteur et les pixels suivent.</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>Hauteur sur papier</translation>
    </message>
    <message>
        <source>Height on paper; the width and the pixels follow.</source>
        <translation>Hauteur sur papier ; la largeur et les pixels suivent.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>po</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Millimètres ou pouces</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Pixels an inch. PNG, TIFF, JPEG and EXR files say it.</source>
        <translation>Pixels par pouce. Les fichiers PNG, TIFF, JPEG et EXR l’indiquent.</translation>
    </message>
</context>
<context>
    <name>suffuse::ProbePanel</name>
    <message>
        <source>Rest the pointer on the painting: what it is made of there is listed here, and stays when you come here to click it.</source>
        <translation>Posez le pointeur sur le tableau : ce dont il est fait à cet endroit s’affiche ici, et y reste quand vous venez cliquer dessus.</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Trait</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Densité φ</translation>
    </message>
    <message>
        <source>Of strokes: share of the colour. Of segments: share of the stroke&apos;s density.</source>
        <translation>Pour les traits : part de la couleur. Pour les segments : part de la densité du trait.</translation>
    </message>
    <message>
        <source>Strokes under the pointer</source>
        <translation>Traits sous le pointeur</translation>
    </message>
    <message>
        <source>Density over the age</source>
        <translation>Densité selon l’âge</translation>
    </message>
    <message>
        <source>The density of the chosen stroke at this place from when it was painted until it is dry. Dashed: the density from which it is seen.</source>
        <translation>La densité du trait choisi à cet endroit, du moment où il a été peint jusqu’à ce qu’il soit sec. En tirets : la densité à partir de laquelle on le voit.</translation>
    </message>
    <message>
        <source>%1, %2 · paper η %3</source>
        <translation>%1, %2 · papier η %3</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canevas</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trait %1</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>The topmost stroke comes first, with its share of the colour.</source>
        <translation>Le trait le plus haut vient en premier, avec sa part de la couleur.</translation>
    </message>
</context>
<context>
    <name>suffuse::PushTool</name>
    <message>
        <source>Drag to push strokes along. [ and ] change the size.</source>
        <translation>Glisser pour pousser des traits. [ et ] changent la taille.</translation>
    </message>
    <message>
        <source>Drag to push the selected strokes along. [ and ] change the size.</source>
        <translation>Glisser pour pousser les traits sélectionnés. [ et ] changent la taille.</translation>
    </message>
    <message>
        <source>Drag to turn strokes into the direction of the drag.</source>
        <translation>Glisser pour tourner des traits dans la direction du geste.</translation>
    </message>
    <message>
        <source>Drag to turn the selected strokes into the direction of the drag.</source>
        <translation>Glisser pour tourner les traits sélectionnés dans la direction du geste.</translation>
    </message>
    <message>
        <source>Hold to pull strokes together. Shift: apart.</source>
        <translation>Maintenir pour rapprocher des traits. Maj : les écarter.</translation>
    </message>
    <message>
        <source>Hold to pull the selected strokes together. Shift: apart.</source>
        <translation>Maintenir pour rapprocher les traits sélectionnés. Maj : les écarter.</translation>
    </message>
    <message>
        <source>Drag to roughen strokes.</source>
        <translation>Glisser pour hérisser des traits.</translation>
    </message>
    <message>
        <source>Drag to roughen the selected strokes.</source>
        <translation>Glisser pour hérisser les traits sélectionnés.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Pousser</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peigner</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Pincer</translation>
    </message>
    <message>
        <source>Roughen</source>
        <translation>Hérisser</translation>
    </message>
    <message>
        <source>What the circle does to strokes</source>
        <translation>Ce que le cercle fait aux traits</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>How much of it one touch does; a pen&apos;s pressure takes from it</source>
        <translation>L’effet d’un seul passage ; un appui léger du stylet le réduit</translation>
    </message>
    <message>
        <source>Push strokes</source>
        <translation>Pousser les traits</translation>
    </message>
    <message>
        <source>Comb strokes</source>
        <translation>Peigner les traits</translation>
    </message>
    <message>
        <source>Pinch strokes</source>
        <translation>Pincer les traits</translation>
    </message>
    <message>
        <source>Roughen strokes</source>
        <translation>Hérisser les traits</translation>
    </message>
    <message>
        <source>Letters are left alone while nothing is selected. Select the text to change its letters.</source>
        <translation>Les lettres ne bougent pas tant que rien n’est sélectionné. Sélectionnez le texte pour changer ses lettres.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message>
        <source>Recolour Artwork</source>
        <translation>Redéfinir les couleurs</translation>
    </message>
    <message>
        <source>Colours of what is selected</source>
        <translation>Couleurs de la sélection</translation>
    </message>
    <message>
        <source>Colours of the painting</source>
        <translation>Couleurs du tableau</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>The colours with the most paint come first. Choose one, or several, and give it another colour: it changes everywhere.</source>
        <translation>Les couleurs ayant le plus de peinture viennent en premier. Choisissez-en une, ou plusieurs, et donnez-lui une autre couleur : elle change partout.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peinture</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>%n couleur semblable</numerusform>
            <numerusform>%n couleurs semblables</numerusform>
        </translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>Couleur sRGB sous forme #rrggbb, #rgb ou CSS : rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>Nuancier</translation>
    </message>
    <message>
        <source>The swatches of the painting. Click: the chosen colour becomes this one.</source>
        <translation>Les nuances du tableau. Clic : la couleur choisie devient celle-ci.</translation>
    </message>
    <message>
        <source>Keep differences</source>
        <translation>Garder les différences</translation>
    </message>
    <message>
        <source>Colours that are one line in the list change together and stay different. Else they become the same.</source>
        <translation>Les couleurs qui forment une ligne de la liste changent ensemble et restent différentes. Sinon, elles deviennent identiques.</translation>
    </message>
    <message>
        <source>Reset the Colour</source>
        <translation>Réinitialiser la couleur</translation>
    </message>
    <message>
        <source>Gives the chosen colours back what they were</source>
        <translation>Rend aux couleurs choisies leur valeur d’origine</translation>
    </message>
    <message>
        <source>All colours</source>
        <translation>Toutes les couleurs</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Turns all hues around the colour wheel</source>
        <translation>Tourne toutes les teintes sur la roue des couleurs</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>100 %: as it is; 0 %: grey; more: more colourful</source>
        <translation>100 % : inchangée ; 0 % : gris ; au-delà : plus coloré</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Clarté</translation>
    </message>
    <message>
        <source>Above 0 % nearer to white, below nearer to black</source>
        <translation>Au-dessus de 0 %, plus près du blanc ; au-dessous, du noir</translation>
    </message>
    <message>
        <source>Map to the nearest swatches</source>
        <translation>Associer aux nuances les plus proches</translation>
    </message>
    <message>
        <source>Each colour becomes the swatch of the painting that looks nearest</source>
        <translation>Chaque couleur devient la nuance du tableau qui lui ressemble le plus</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>« %1 » n’est pas une couleur. Écrivez-la sous forme #rrggbb, par exemple #2f6690.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message>
        <source>Recover Paintings</source>
        <translation>Récupérer des tableaux</translation>
    </message>
    <message>
        <source>Suffuse ended before these paintings were saved. They open as they were at the last stroke; files on the disk are left as they are.</source>
        <translation>Suffuse s’est arrêté avant que ces tableaux soient enregistrés. Ils s’ouvrent tels qu’ils étaient au dernier trait ; les fichiers sur le disque restent tels quels.</translation>
    </message>
    <message>
        <source>Paintings that can be recovered</source>
        <translation>Tableaux qui peuvent être récupérés</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Last Change</source>
        <translation>Dernière modification</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Récupérer</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Plus tard</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Abandonner…</translation>
    </message>
    <message>
        <source>Opens the selected paintings, without a file of their own</source>
        <translation>Ouvre les tableaux sélectionnés, sans fichier associé</translation>
    </message>
    <message>
        <source>Asks again when Suffuse starts the next time</source>
        <translation>Redemande au prochain lancement de Suffuse</translation>
    </message>
    <message>
        <source>Removes the selected paintings for good</source>
        <translation>Supprime définitivement les tableaux sélectionnés</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistré</translation>
    </message>
    <message>
        <source>Discard “%1”?</source>
        <translation>Abandonner « %1 » ?</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>Abandonner %n tableau ?</numerusform>
            <numerusform>Abandonner %n tableaux ?</numerusform>
        </translation>
    </message>
    <message>
        <source>What was painted since the last save is then lost for good.</source>
        <translation>Ce qui a été peint depuis le dernier enregistrement sera alors perdu pour de bon.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
</context>
<context>
    <name>suffuse::RedrawTool</name>
    <message>
        <source>Draw from a stroke and back to it: the part between follows the line.</source>
        <translation>Dessiner depuis un trait et y revenir : la partie entre les deux suit la ligne.</translation>
    </message>
    <message>
        <source>Draw from a selected stroke and back to it: the part between follows.</source>
        <translation>Dessiner depuis un trait sélectionné et y revenir : la partie entre les deux suit.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>Comme avant</translation>
    </message>
    <message>
        <source>Of the brush in hand</source>
        <translation>Du pinceau en main</translation>
    </message>
    <message>
        <source>What the new part is painted with, and when</source>
        <translation>Avec quoi la nouvelle partie est peinte, et quand</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Redessiner</translation>
    </message>
    <message>
        <source>The line begins and ends at no stroke that can be changed.</source>
        <translation>La ligne ne commence ni ne finit sur aucun trait modifiable.</translation>
    </message>
    <message>
        <source>The line begins and ends at no selected stroke that can be changed.</source>
        <translation>La ligne ne commence ni ne finit sur aucun trait sélectionné modifiable.</translation>
    </message>
</context>
<context>
    <name>suffuse::ReshapeDialog</name>
    <message>
        <source>Reshape</source>
        <translation>Remodeler</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplifier</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Grow or shrink</source>
        <translation>Élargir ou rétrécir</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>How far curves may move</source>
        <translation>De combien les courbes peuvent bouger</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>How far spreads, densities, colours and times may differ that become one</source>
        <translation>De combien peuvent différer les étalements, densités, couleurs et temps qui ne font plus qu’un</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Wiggles of this length and shorter ones go</source>
        <translation>Les ondulations de cette longueur, et les plus courtes, disparaissent</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>0 %: as it is; 100 %: a straight line</source>
        <translation>0 % : tel quel ; 100 % : une ligne droite</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Of the paint; below 100 % it shrinks</source>
        <translation>De la peinture ; au-dessous de 100 %, elle rétrécit</translation>
    </message>
    <message>
        <source>To the right of the stroke&apos;s direction; below 0 to the left</source>
        <translation>À droite du sens du trait ; au-dessous de 0, à gauche</translation>
    </message>
    <message>
        <source>%1 → %2 segments</source>
        <extracomment>%1, %2: numbers of segments before and after</extracomment>
        <translation>%1 → %2 segments</translation>
    </message>
    <message>
        <source>%1, picture differs by %2</source>
        <extracomment>%1: &quot;12 → 3 segments&quot;; %2: &quot;0.4 %&quot;, the mean difference of the pictures</extracomment>
        <translation>%1, l’image diffère de %2</translation>
    </message>
</context>
<context>
    <name>suffuse::RewetRows</name>
    <message>
        <source>Wetted again</source>
        <translation>Réhumidifié</translation>
    </message>
    <message>
        <source>… and more</source>
        <translation>… et d’autres</translation>
    </message>
    <message>
        <source>at %1 for %2 s</source>
        <translation>à %1 pendant %2 s</translation>
    </message>
    <message>
        <source>at %1 for %2 s, some segments</source>
        <translation>à %1 pendant %2 s, certains segments</translation>
    </message>
    <message>
        <source>The selected paint is not wetted then</source>
        <translation>La peinture sélectionnée n’y est pas réhumidifiée</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Supprimer la réhumidification</translation>
    </message>
</context>
<context>
    <name>suffuse::ScreenColourRows</name>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Hue on the circle of the screen&apos;s colours: 0° red, 120° green, 240° blue</source>
        <translation>Teinte sur le cercle des couleurs de l’écran : 0° rouge, 120° vert, 240° bleu</translation>
    </message>
    <message>
        <source>0 %: grey; 100 %: as colourful as a screen can be</source>
        <translation>0 % : gris ; 100 % : aussi coloré qu’un écran le peut</translation>
    </message>
    <message>
        <source>0 %: black; 100 %: as bright as the colour can be</source>
        <translation>0 % : noir ; 100 % : aussi lumineux que la couleur le peut</translation>
    </message>
    <message>
        <source>Red light of the screen, 0 to 255</source>
        <translation>Lumière rouge de l’écran, de 0 à 255</translation>
    </message>
    <message>
        <source>Green light of the screen, 0 to 255</source>
        <translation>Lumière verte de l’écran, de 0 à 255</translation>
    </message>
    <message>
        <source>Blue light of the screen, 0 to 255</source>
        <translation>Lumière bleue de l’écran, de 0 à 255</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>V</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>suffuse::SegmentSection</name>
    <message>
        <source>Diffusion D</source>
        <translation>Diffusion D</translation>
    </message>
    <message>
        <source>How fast the paint spreads: the spread grows with the root of D times time.</source>
        <translation>À quelle vitesse la peinture s’étale : l’étalement croît avec la racine de D fois le temps.</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Densité φ</translation>
    </message>
    <message>
        <source>How much paint the segment gives off along its length.</source>
        <translation>Combien de peinture le segment libère sur sa longueur.</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Temps de séchage</translation>
    </message>
    <message>
        <source>t_max: how long the paint spreads after it was laid down.</source>
        <translation>t_max : combien de temps la peinture s’étale après avoir été posée.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message>
        <source>Change diffusion</source>
        <translation>Changer la diffusion</translation>
    </message>
    <message>
        <source>Change density</source>
        <translation>Changer la densité</translation>
    </message>
    <message>
        <source>Change granulation</source>
        <translation>Changer la granulation</translation>
    </message>
    <message>
        <source>Change drying time</source>
        <translation>Changer le temps de séchage</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Couleur de la sélection</translation>
    </message>
    <message>
        <source>Colour of the selection. Click: paint with it.</source>
        <translation>Couleur de la sélection. Clic : peindre avec.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Changer la couleur</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Direction of the anisotropy, clockwise from the horizontal.</source>
        <translation>Direction de l’anisotropie, dans le sens horaire depuis l’horizontale.</translation>
    </message>
    <message>
        <source>Change anisotropy</source>
        <translation>Changer l’anisotropie</translation>
    </message>
    <message>
        <source>Change angle</source>
        <translation>Changer l’angle</translation>
    </message>
    <message>
        <source>How many times D along the angle is D across it; 1 spreads evenly.</source>
        <translation>Rapport entre D le long de l’angle et D en travers ; à 1, l’étalement est uniforme.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How much the paint covers at full density</source>
        <translation>À quel point la peinture couvre à pleine densité</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Share of red pigment</source>
        <translation>Part de pigment rouge</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>Share of yellow pigment</source>
        <translation>Part de pigment jaune</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Share of blue pigment</source>
        <translation>Part de pigment bleu</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Naissance</translation>
    </message>
    <message>
        <source>When the stroke, or what is selected of it, begins. All of that moves in time as one.</source>
        <translation>Quand commence le trait, ou ce qui en est sélectionné. Tout cela se déplace ensemble dans le temps.</translation>
    </message>
    <message>
        <source>Change birth</source>
        <translation>Changer la naissance</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Changer %1</translation>
    </message>
    <message>
        <source>Granulation</source>
        <translation>Granulation</translation>
    </message>
    <message>
        <source>How much of the paper&apos;s grain shows: 0 % is smooth, 100 % shows all of it. Files and scripts hold ω, which is 1 where this is 0 %.</source>
        <translation>À quel point le grain du papier apparaît : 0 % est lisse, 100 % le montre en entier. Fichiers et scripts contiennent ω, qui vaut 1 là où ceci vaut 0 %.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width of a dry line at full pressure, in units; sets the diffusion.</source>
        <translation>Largeur d’une ligne sèche à pleine pression, en unités ; règle la diffusion.</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Débit</translation>
    </message>
    <message>
        <source>Density in the middle of the stroke at full pressure.</source>
        <translation>Densité au milieu du trait à pleine pression.</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Its length on the screen</source>
        <translation>Sa longueur à l’écran</translation>
    </message>
    <message>
        <source>Pigment β</source>
        <translation>Pigment β</translation>
    </message>
    <message>
        <source>Share of the colour below that stays: 0 % covers, 100 % adds.</source>
        <translation>Part de la couleur du dessous qui reste : 0 % couvre, 100 % additionne.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>How deep the grain goes.</source>
        <translation>Profondeur du grain.</translation>
    </message>
    <message>
        <source>How far the stroke lags behind</source>
        <translation>Retard du trait sur le stylet</translation>
    </message>
    <message>
        <source>Parameter of the style</source>
        <translation>Paramètre du style</translation>
    </message>
    <message>
        <source>Threshold ξ1</source>
        <translation>Seuil ξ1</translation>
    </message>
    <message>
        <source>Softness ξ2</source>
        <translation>Douceur ξ2</translation>
    </message>
    <message>
        <source>Full at ξ1</source>
        <translation>Plein à ξ1</translation>
    </message>
    <message>
        <source>Steepness ξ2</source>
        <translation>Raideur ξ2</translation>
    </message>
    <message>
        <source>Edge ξ1</source>
        <translation>Bord ξ1</translation>
    </message>
    <message>
        <source>Lightening ξ2</source>
        <translation>Clarté int. ξ2</translation>
    </message>
    <message>
        <source>Strength ξ3</source>
        <translation>Intensité ξ3</translation>
    </message>
    <message>
        <source>Density at which the stroke covers by half.</source>
        <translation>Densité à laquelle le trait couvre à moitié.</translation>
    </message>
    <message>
        <source>How gently the edge fades.</source>
        <translation>Avec quelle douceur le bord se fond.</translation>
    </message>
    <message>
        <source>Density from which the stroke covers fully.</source>
        <translation>Densité à partir de laquelle le trait couvre entièrement.</translation>
    </message>
    <message>
        <source>How steeply coverage grows with density.</source>
        <translation>Avec quelle raideur la couverture croît avec la densité.</translation>
    </message>
    <message>
        <source>Density at which the dark rim stands.</source>
        <translation>Densité à laquelle se trouve le bord sombre.</translation>
    </message>
    <message>
        <source>How much the inside is lighter than the rim; at most 1.26·ξ1.</source>
        <translation>De combien l’intérieur est plus clair que le bord ; au plus 1,26·ξ1.</translation>
    </message>
    <message>
        <source>Coverage far inside the stroke.</source>
        <translation>Couverture loin à l’intérieur du trait.</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Feathering</source>
        <translation>Bords fondus</translation>
    </message>
    <message>
        <source>Dark edges</source>
        <translation>Bords sombres</translation>
    </message>
    <message>
        <source>Covering (alpha)</source>
        <translation>Couvrant (alpha)</translation>
    </message>
    <message>
        <source>Pigment (β)</source>
        <translation>Pigment (β)</translation>
    </message>
    <message>
        <source>Erasure</source>
        <translation>Effacement</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Pondéré</translation>
    </message>
    <message>
        <source>Pulled string</source>
        <translation>Fil tiré</translation>
    </message>
</context>
<context>
    <name>suffuse::SelectTool</name>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.</source>
        <translation>Trait %1 sur %2 sous le pointeur, depuis le haut. Alt+clic encore : le suivant en dessous.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Mettre à l’échelle</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>Incliner</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1 : %2 de %3</translation>
    </message>
    <message>
        <source>%1: moved by %2, %3</source>
        <translation>%1 : déplacé de %2, %3</translation>
    </message>
</context>
<context>
    <name>suffuse::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Colours of the windows</source>
        <translation>Couleurs des fenêtres</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canevas</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>Matriciel</translation>
    </message>
    <message>
        <source>All cores</source>
        <translation>Tous les cœurs</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>Rendu</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stylet</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sauvegardes</translation>
    </message>
    <message>
        <source>How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the last one, “~2” the one before. File ▸ Restore Backup brings one back.</source>
        <translation>Combien de versions antérieures sont gardées quand un tableau est enregistré : « nom.suffuse~ » à côté de lui est la dernière, « ~2 » celle d’avant. Fichier ▸ Restaurer une sauvegarde permet d’y revenir.</translation>
    </message>
    <message>
        <source>Language of the program</source>
        <translation>Langue du programme</translation>
    </message>
    <message>
        <source>How the picture comes to the screen</source>
        <translation>Comment l’image arrive à l’écran</translation>
    </message>
    <message>
        <source>What computes the picture</source>
        <translation>Ce qui calcule l’image</translation>
    </message>
    <message>
        <source>Processor threads for drawing</source>
        <translation>Threads du processeur pour dessiner</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Whether docks glide to their places and carets blink</source>
        <translation>Si les panneaux glissent à leur place et si les curseurs de texte clignotent</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Réduit</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Complet</translation>
    </message>
</context>
<context>
    <name>suffuse::SheetView</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
</context>
<context>
    <name>suffuse::ShortcutsDialog</name>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Rechercher des raccourcis</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut holds this text.</source>
        <translation>Ne montre que les commandes dont le nom ou le raccourci contient ce texte.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Choose a command, then press its new shortcut below.</source>
        <translation>Choisissez une commande, puis appuyez ci-dessous sur son nouveau raccourci.</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>Appuyez sur les touches</translation>
    </message>
    <message>
        <source>No shortcut for this command</source>
        <translation>Aucun raccourci pour cette commande</translation>
    </message>
    <message>
        <source>This command&apos;s own shortcut</source>
        <translation>Le raccourci d’origine de cette commande</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” and “%3”. Give one of them another shortcut.</source>
        <translation>%1 appartient à « %2 » et à « %3 ». Donnez à l’une d’elles un autre raccourci.</translation>
    </message>
    <message>
        <source>Takes the shortcut away from the other command</source>
        <translation>Retire le raccourci à l’autre commande</translation>
    </message>
    <message>
        <source>Fixed: no command can have these keys.</source>
        <translation>Fixes : aucune commande ne peut avoir ces touches.</translation>
    </message>
    <message>
        <source>%1 is fixed: “%2”. Give “%3” another shortcut.</source>
        <translation>%1 est fixe : « %2 ». Donnez à « %3 » un autre raccourci.</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>A&amp;ucun</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>Réattribu&amp;er</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there.</source>
        <translation>Où le raccourci fonctionne. Ce que l’on tape dans un panneau, sans Ctrl ni Alt, y reste.</translation>
    </message>
</context>
<context>
    <name>suffuse::SizedTool</name>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Diameter of the circle ([ and ] change it)</source>
        <translation>Diamètre du cercle ([ et ] le changent)</translation>
    </message>
</context>
<context>
    <name>suffuse::SliderField</name>
    <message>
        <source>Double-click: back to the default.</source>
        <translation>Double-clic : revenir à la valeur par défaut.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, curseur</translation>
    </message>
    <message>
        <source>The values differ. The slider multiplies each of them; with Ctrl it makes them one.</source>
        <translation>Les valeurs diffèrent. Le curseur multiplie chacune d’elles ; avec Ctrl, il les rend égales.</translation>
    </message>
    <message>
        <source>The values differ. The slider adds to each of them; with Ctrl it makes them one.</source>
        <translation>Les valeurs diffèrent. Le curseur ajoute à chacune d’elles ; avec Ctrl, il les rend égales.</translation>
    </message>
    <message>
        <source>The values differ. A number makes them one; *1.2 or +2 changes each of them.</source>
        <translation>Les valeurs diffèrent. Un nombre les rend égales ; *1.2 ou +2 change chacune d’elles.</translation>
    </message>
</context>
<context>
    <name>suffuse::SoftReach</name>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>How far along the stroke a dragged node or curve takes along what lies near; 0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)</source>
        <translation>Jusqu’où, le long du trait, un nœud ou une courbe que l’on tire entraîne ce qui est proche ; 0 : rien (la molette ou [ et ] en glissant, ou Alt+glisser, la changent)</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Let the reach follow the view: soft where nodes would crowd, else the node alone</source>
        <translation>Laisser la portée suivre la vue : douce là où les nœuds seraient trop serrés, sinon le nœud seul</translation>
    </message>
    <message>
        <source>Let the reach follow the view</source>
        <translation>Laisser la portée suivre la vue</translation>
    </message>
</context>
<context>
    <name>suffuse::StatusLine</name>
    <message>
        <source>Position of the pointer, in what the rulers count</source>
        <translation>Position du pointeur, dans l’unité des règles</translation>
    </message>
    <message>
        <source>Zoom, and the angle by which the canvas is turned</source>
        <translation>Zoom, et angle dont le canevas est tourné</translation>
    </message>
    <message>
        <source>What renders the picture</source>
        <translation>Ce qui fait le rendu de l’image</translation>
    </message>
    <message>
        <source>Time that the last frame took</source>
        <translation>Temps qu’a pris la dernière image</translation>
    </message>
    <message>
        <source>You paint in the past: what came later covers it.</source>
        <extracomment>instead of what the brush does, while the timeline shows a moment of the past</extracomment>
        <translation>Vous peignez dans le passé : ce qui est venu plus tard le couvre.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>a position: x, y</extracomment>
        <translation>%1 ; %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms, coarse</source>
        <translation>%1 ms, grossier</translation>
    </message>
    <message>
        <source>Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and lifts it; + and - change its pressure; Esc puts it away.</source>
        <translation>Les touches fléchées déplacent le stylet, loin avec Maj et finement avec Alt ; Espace l’abaisse et le relève ; + et - changent sa pression ; Échap le range.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeHistoryList</name>
    <message>
        <source>History of the selected stroke</source>
        <translation>Historique du trait sélectionné</translation>
    </message>
    <message>
        <source>What was done to the selected stroke. Click a state to put this stroke back to it; everything else stays as it is.</source>
        <translation>Ce qui a été fait au trait sélectionné. Cliquez sur un état pour y ramener ce trait ; tout le reste demeure tel quel.</translation>
    </message>
    <message>
        <source>As it was at first</source>
        <translation>Tel qu’il était d’abord</translation>
    </message>
    <message>
        <source>Put stroke back</source>
        <translation>Restaurer le trait</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeSection</name>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of the selected strokes, as the list of strokes shows it.</source>
        <translation>Nom des traits sélectionnés, tel que le montre la liste des traits.</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Renommer le trait</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Comment la peinture se mélange à ce qui est dessous : elle couvre, ou les pigments s’additionnent.</translation>
    </message>
    <message>
        <source>Change pigment mixing</source>
        <translation>Changer le mélange des pigments</translation>
    </message>
    <message>
        <source>Change mixing</source>
        <translation>Changer le mélange</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>sans nom</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
    <message>
        <source>The mixing of the wash is seen in place of this one.</source>
        <translation>Le mélange du lavis s’applique à la place de celui-ci.</translation>
    </message>
</context>
<context>
    <name>suffuse::WashRows</name>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>How the density of all strokes of the wash becomes coverage.</source>
        <translation>Comment la densité de tous les traits du lavis devient couverture.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>How the wash mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Comment le lavis se mélange à ce qui est dessous : il couvre, ou les pigments s’additionnent.</translation>
    </message>
    <message>
        <source>Change wash</source>
        <translation>Changer le lavis</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>Impossible pour toute la sélection : %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Visible. Click: hide.</source>
        <translation>Visible. Clic : masquer.</translation>
    </message>
    <message>
        <source>Hidden. Click: show.</source>
        <translation>Masqué. Clic : afficher.</translation>
    </message>
    <message>
        <source>Locked. Click: unlock.</source>
        <translation>Verrouillé. Clic : déverrouiller.</translation>
    </message>
    <message>
        <source>Not locked. Click: lock.</source>
        <translation>Non verrouillé. Clic : verrouiller.</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Trait %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Renommer le groupe</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Renommer le trait</translation>
    </message>
    <message>
        <source>Hide group</source>
        <translation>Masquer le groupe</translation>
    </message>
    <message>
        <source>Show group</source>
        <translation>Afficher le groupe</translation>
    </message>
    <message>
        <source>Unlock group</source>
        <translation>Déverrouiller le groupe</translation>
    </message>
    <message>
        <source>Lock group</source>
        <translation>Verrouiller le groupe</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Masquer le trait</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Afficher le trait</translation>
    </message>
    <message>
        <source>Unlock stroke</source>
        <translation>Déverrouiller le trait</translation>
    </message>
    <message>
        <source>Lock stroke</source>
        <translation>Verrouiller le trait</translation>
    </message>
    <message>
        <source>Reorder strokes</source>
        <translation>Réordonner les traits</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>All in it is hidden. Click: show it.</source>
        <translation>Tout son contenu est masqué. Clic : l’afficher.</translation>
    </message>
    <message>
        <source>Some of it is hidden. Click: hide the group.</source>
        <translation>Une partie est masquée. Clic : masquer le groupe.</translation>
    </message>
    <message>
        <source>All in it is locked. Click: unlock it.</source>
        <translation>Tout son contenu est verrouillé. Clic : le déverrouiller.</translation>
    </message>
    <message>
        <source>Some of it is locked. Click: lock the group.</source>
        <translation>Une partie est verrouillée. Clic : verrouiller le groupe.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>%Ln morceau</numerusform>
            <numerusform>%Ln morceaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>%Ln effacement</numerusform>
            <numerusform>%Ln effacements</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between &quot;3 pieces&quot; and &quot;12 erasures&quot;</extracomment>
        <translation>, </translation>
    </message>
    <message>
        <source>mixes by itself</source>
        <translation>se mélange à part</translation>
    </message>
    <message>
        <source>%1, painted on</source>
        <translation>%1, on y peint</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesPanel</name>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search strokes</source>
        <translation>Rechercher des traits</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>The topmost stroke comes first. Drag to reorder, double-click to rename; a right click offers more.</source>
        <translation>Le trait le plus haut vient en premier. Glisser pour réordonner, double-clic pour renommer ; clic droit : plus d’options.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>Mo&amp;ve Up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>Select rows to move them.</source>
        <translation>Sélectionnez des lignes pour les déplacer.</translation>
    </message>
    <message>
        <source>Nothing changes: this is on top already.</source>
        <translation>Rien ne change : c’est déjà tout en haut.</translation>
    </message>
    <message>
        <source>Nothing changes: this is at the bottom already.</source>
        <translation>Rien ne change : c’est déjà tout en bas.</translation>
    </message>
    <message>
        <source>Nothing changes: locked strokes stay in place.</source>
        <translation>Rien ne change : les traits verrouillés restent en place.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Select &amp;Same</source>
        <translation>Sélectionner d&amp;e même</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Couleur</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>St&amp;yle</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Mas&amp;quer</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>Déverro&amp;uiller</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Verrouiller</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Masquer les traits</translation>
    </message>
    <message>
        <source>Show strokes</source>
        <translation>Afficher les traits</translation>
    </message>
    <message>
        <source>Unlock strokes</source>
        <translation>Déverrouiller les traits</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Verrouiller les traits</translation>
    </message>
    <message>
        <source>Shows only strokes and groups whose name holds this text. Return selects them.</source>
        <translation>Ne montre que les traits et groupes dont le nom contient ce texte. Entrée les sélectionne.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>No stroke is called “%1”.</source>
        <translation>Aucun trait ne s’appelle « %1 ».</translation>
    </message>
    <message>
        <source>While the list is searched, rows are not dragged: between those that show there may be others. Clear the search first.</source>
        <translation>Pendant une recherche dans la liste, on n’y déplace pas de lignes : entre celles qui s’affichent, il peut y en avoir d’autres. Effacez d’abord la recherche.</translation>
    </message>
    <message>
        <source>Mi&amp;x by Itself</source>
        <translation>Mélanger à &amp;part</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Mélanger le groupe à part</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Mélanger le groupe à ce qui est dessous</translation>
    </message>
    <message>
        <source>New layer: %1</source>
        <translation>Nouveau calque : %1</translation>
    </message>
    <message>
        <source>Painting on: %1</source>
        <translation>Peinture sur : %1</translation>
    </message>
    <message>
        <source>The layer comes into the list with the first stroke that is painted.</source>
        <translation>Le calque apparaît dans la liste avec le premier trait peint.</translation>
    </message>
    <message>
        <source>What is painted goes into this group. A click beside all rows: on top of all again.</source>
        <translation>Ce que l’on peint va dans ce groupe. Un clic hors des lignes : de nouveau par-dessus tout.</translation>
    </message>
    <message>
        <source>Painting on top of all</source>
        <translation>Peinture par-dessus tout</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>M&amp;ode</translation>
    </message>
    <message>
        <source>O&amp;pacity…</source>
        <translation>Opaci&amp;té…</translation>
    </message>
    <message>
        <source>New clipped layer: %1</source>
        <translation>Nouveau calque écrêté : %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StyleSection</name>
    <message>
        <source>Style</source>
        <translation>Style</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Appartient</translation>
    </message>
    <message>
        <source>Whether the segments follow their stroke&apos;s style or have their own.</source>
        <translation>Si les segments suivent le style de leur trait ou ont le leur.</translation>
    </message>
    <message>
        <source>The stroke</source>
        <translation>Au trait</translation>
    </message>
    <message>
        <source>These segments</source>
        <translation>À ces segments</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Comment la densité devient couverture.</translation>
    </message>
    <message>
        <source>Change style</source>
        <translation>Changer le style</translation>
    </message>
    <message>
        <source>Give segments their own style</source>
        <translation>Donner aux segments leur propre style</translation>
    </message>
    <message>
        <source>Follow the stroke&apos;s style</source>
        <translation>Suivre le style du trait</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>Impossible pour toute la sélection : %1</translation>
    </message>
    <message>
        <source>The style of the wash is seen in place of this one.</source>
        <translation>Le style du lavis s’applique à la place de celui-ci.</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchGrid</name>
    <message>
        <source>Add swatch</source>
        <translation>Ajouter une nuance</translation>
    </message>
    <message>
        <source>Move swatch</source>
        <translation>Déplacer la nuance</translation>
    </message>
    <message>
        <source>Rename swatch</source>
        <translation>Renommer la nuance</translation>
    </message>
    <message>
        <source>Remove swatch</source>
        <translation>Supprimer la nuance</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Link swatch</source>
        <translation>Lier la nuance</translation>
    </message>
    <message>
        <source>Unlink swatch</source>
        <translation>Délier la nuance</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>liée</translation>
    </message>
    <message>
        <source>Change the Colour</source>
        <translation>Changer la couleur</translation>
    </message>
    <message>
        <source>Linked to What Is Painted with It</source>
        <translation>Liée à ce qui est peint avec</translation>
    </message>
    <message>
        <source>Select What Has This Colour</source>
        <translation>Sélectionner ce qui a cette couleur</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchesSection</name>
    <message>
        <source>Swatches</source>
        <translation>Nuancier</translation>
    </message>
    <message>
        <source>Add swatch</source>
        <translation>Ajouter une nuance</translation>
    </message>
    <message>
        <source>Keeps the current colour with the painting.</source>
        <translation>Garde la couleur actuelle avec le tableau.</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Palettes</translation>
    </message>
    <message>
        <source>GIMP palettes in and out</source>
        <translation>Importer et exporter des palettes GIMP</translation>
    </message>
    <message>
        <source>Colours kept with the painting. Click: take it. Drag to move; Delete removes.</source>
        <translation>Couleurs gardées avec le tableau. Clic : la prendre. Glisser pour déplacer ; Suppr supprime.</translation>
    </message>
    <message>
        <source>None yet: + keeps the current colour.</source>
        <translation>Aucune encore : + garde la couleur actuelle.</translation>
    </message>
    <message>
        <source>GIMP palettes</source>
        <translation>Palettes GIMP</translation>
    </message>
    <message>
        <source>Import palette</source>
        <translation>Importer une palette</translation>
    </message>
    <message>
        <source>Export palette</source>
        <translation>Exporter une palette</translation>
    </message>
    <message>
        <source>Remove all swatches</source>
        <translation>Supprimer toutes les nuances</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>Impossible de lire %1 : %2.</translation>
    </message>
    <message>
        <source>Map Colours to Swatches</source>
        <translation>Associer les couleurs aux nuances</translation>
    </message>
    <message>
        <source>Gives what is selected, or else all of the painting, the swatch that looks nearest</source>
        <translation>Donne à la sélection, ou sinon à tout le tableau, la nuance la plus ressemblante</translation>
    </message>
    <message>
        <source>Import Palette…</source>
        <translation>Importer une palette…</translation>
    </message>
    <message>
        <source>Export Palette…</source>
        <translation>Exporter une palette…</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Tout supprimer</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message>
        <source>The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg or pfm numbered pictures, such as frame%04d.png.</source>
        <translation>L’extension choisit le format : webm ou mp4 est une vidéo, webp une animation, et png, tiff, exr, jpg ou pfm des images numérotées, comme frame%04d.png.</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> images/s</translation>
    </message>
    <message>
        <source>How many pictures a second the film has</source>
        <translation>Combien d’images par seconde a le film</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How long the film is; the painting&apos;s time is stretched over it.</source>
        <translation>Durée du film ; le temps du tableau est étiré en conséquence.</translation>
    </message>
    <message>
        <source>Animated WebP: begins anew at its end. Players decide it for videos.</source>
        <translation>WebP animé : recommence à sa fin. Pour les vidéos, le lecteur décide.</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Films</translation>
    </message>
    <message>
        <source>Numbered pictures</source>
        <translation>Images numérotées</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>A film of %1 frames is too long. Choose a lower rate or a shorter length.</source>
        <translation>Un film de %1 images est trop long. Choisissez une cadence plus basse ou une durée plus courte.</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>Writing the film…</source>
        <translation>Écriture du film…</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1 ; encore %n seconde</numerusform>
            <numerusform>%1 ; encore %n secondes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1 ; encore %n minute</numerusform>
            <numerusform>%1 ; encore %n minutes</numerusform>
        </translation>
    </message>
    <message>
        <source>Longest pause</source>
        <translation>Pause maximale</translation>
    </message>
    <message>
        <source>Pauses in which nothing is painted or spreads are cut to this, in the painting&apos;s time.</source>
        <translation>Les pauses où rien n’est peint ni ne s’étale sont réduites à cette durée, dans le temps du tableau.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>En boucle</translation>
    </message>
    <message>
        <source>Export Timelapse</source>
        <translation>Exporter un accéléré</translation>
    </message>
    <message>
        <source>“%1” has no ending of a film or a picture. Choose one of: %2.</source>
        <translation>« %1 » n’a pas d’extension de film ou d’image. Choisissez-en une : %2.</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePanel</name>
    <message>
        <source>%1 is out of range: 0.1 to 1000 times is possible.</source>
        <translation>%1 est hors limites : de 0,1 à 1000 fois.</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end, when all has dried</source>
        <translation>Le moment affiché, et la fin, quand tout est sec</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How fast the painting is played: 0.1 to 1000 times as fast as it was painted</source>
        <translation>À quelle vitesse le tableau est lu : de 0,1 à 1000 fois celle à laquelle il a été peint</translation>
    </message>
    <message>
        <source>Show all of the time (0). Ctrl+wheel zooms.</source>
        <translation>Afficher toute la durée (0). Ctrl+molette : zoomer.</translation>
    </message>
    <message>
        <source>Show all of the time</source>
        <translation>Afficher toute la durée</translation>
    </message>
    <message>
        <source>Go to Its &amp;Start</source>
        <translation>Aller à son &amp;début</translation>
    </message>
    <message>
        <source>Go to When It Is Dr&amp;y</source>
        <translation>Aller au moment où il est se&amp;c</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>Rythme du dessi&amp;n</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePointer</name>
    <message>
        <source>Stroke %1</source>
        <translation>Trait %1</translation>
    </message>
    <message>
        <source>Drawn from %1 to %2</source>
        <translation>Dessiné de %1 à %2</translation>
    </message>
    <message>
        <source>Dry at %1</source>
        <translation>Sec à %1</translation>
    </message>
    <message>
        <source>Erased in part from %1 on</source>
        <translation>Effacé en partie à partir de %1</translation>
    </message>
    <message>
        <source>Wetted again, dry at %1</source>
        <translation>Réhumidifié, sec à %1</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>A bar for each stroke, from when it was painted until it is dry.</source>
        <translation>Une barre pour chaque trait, du moment où il a été peint jusqu’à ce qu’il soit sec.</translation>
    </message>
</context>
<context>
    <name>suffuse::TransformBar</name>
    <message>
        <source>X</source>
        <extracomment>left edge of the selection</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the selected strokes&apos; curves</source>
        <translation>Bord gauche des courbes des traits sélectionnés</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the selected strokes&apos; curves</source>
        <translation>Bord supérieur des courbes des traits sélectionnés</translation>
    </message>
    <message>
        <source>W</source>
        <extracomment>width</extracomment>
        <translation>L</translation>
    </message>
    <message>
        <source>Width of the selected strokes&apos; curves</source>
        <translation>Largeur des courbes des traits sélectionnés</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Garder les proportions de largeur et de hauteur</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Garder les proportions</translation>
    </message>
    <message>
        <source>H</source>
        <extracomment>height</extracomment>
        <translation>H</translation>
    </message>
    <message>
        <source>Height of the selected strokes&apos; curves</source>
        <translation>Hauteur des courbes des traits sélectionnés</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Rotate the selected strokes by this angle</source>
        <translation>Tourner les traits sélectionnés de cet angle</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Mettre à l’échelle</translation>
    </message>
    <message>
        <source>Some of these strokes would become too small, too large or too far away to be painted.</source>
        <translation>Certains de ces traits deviendraient trop petits, trop grands ou trop éloignés pour être peints.</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlayLoader</name>
    <message>
        <source>Underlay</source>
        <translation>Modèle</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlaySection</name>
    <message>
        <source>Add…</source>
        <translation>Ajouter…</translation>
    </message>
    <message>
        <source>A picture to paint over. It shows on the canvas only, never in what is exported.</source>
        <translation>Une image sur laquelle peindre. Elle n’est visible que sur le canevas, jamais dans ce qui est exporté.</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Show the underlay</source>
        <translation>Afficher le modèle</translation>
    </message>
    <message>
        <source>Take the underlay out of the painting</source>
        <translation>Retirer le modèle du tableau</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How strongly the underlay shows.</source>
        <translation>Avec quelle force le modèle apparaît.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the underlay</source>
        <translation>Bord gauche du modèle</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the underlay</source>
        <translation>Bord supérieur du modèle</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width of the underlay</source>
        <translation>Largeur du modèle</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height of the underlay</source>
        <translation>Hauteur du modèle</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Garder les proportions de largeur et de hauteur</translation>
    </message>
    <message>
        <source>Fit to Canvas</source>
        <translation>Ajuster au canevas</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it goes</source>
        <translation>Au milieu du canevas, aussi grand que possible</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Remplacer…</translation>
    </message>
    <message>
        <source>Another picture in its place</source>
        <translation>Une autre image à sa place</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Importer un modèle</translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>From one visible edge of the paint to the other, at its widest, as it is now</source>
        <translation>D’un bord visible de la peinture à l’autre, au plus large, telle qu’elle est maintenant</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>All that is selected</source>
        <translation>Tout ce qui est sélectionné</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>The segment under the pointer alone</source>
        <translation>Seulement le segment sous le pointeur</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Changer la largeur</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, segment %2</source>
        <translation>%1, segment %2</translation>
    </message>
</context>
<context>
    <name>suffuse::ShapeTool</name>
    <message>
        <source>Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.</source>
        <translation>Glisser du milieu à un coin. Maj : pas de 15°. Entrée : comme la dernière.</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.</source>
        <translation>Glisser d’un coin à l’autre. Maj : côtés égaux. Ctrl : depuis le milieu. Entrée : comme la dernière.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Étoile</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Ce qui est dessiné</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Rayon des coins</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Coins</translation>
    </message>
    <message>
        <source>Radius of the corners; half of the shorter side is the most</source>
        <translation>Rayon des coins ; au plus la moitié du côté le plus court</translation>
    </message>
    <message>
        <source>How many corners a polygon, or tips a star has</source>
        <translation>Combien de coins a un polygone, ou de pointes une étoile</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Intérieur</translation>
    </message>
    <message>
        <source>Radius of the inner corners, as a share of that of the tips</source>
        <translation>Rayon des coins intérieurs, en proportion de celui des pointes</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Arrondi</translation>
    </message>
    <message>
        <source>How much of each side is round</source>
        <translation>Quelle part de chaque côté est arrondie</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Where the arc begins, clockwise from the right</source>
        <translation>Où l’arc commence, dans le sens horaire depuis la droite</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arc</translation>
    </message>
    <message>
        <source>How far the arc goes round; 360° is the whole ellipse</source>
        <translation>Jusqu’où tourne l’arc ; 360° est l’ellipse entière</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Secteur</translation>
    </message>
    <message>
        <source>An arc is closed through the middle; else by a straight line</source>
        <translation>Un arc est fermé par le milieu ; sinon par une ligne droite</translation>
    </message>
</context>
<context>
    <name>suffuse::FillSection</name>
    <message>
        <source>How fast the fill spreads: the spread grows with the root of D times time. 0 keeps its edge crisp at any zoom.</source>
        <translation>À quelle vitesse le remplissage s’étale : l’étalement croît avec la racine de D fois le temps. 0 garde son bord net à tout zoom.</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>Densité ρ</translation>
    </message>
    <message>
        <source>Density ρ deep within the fill. On its outline it is half of that, so that with 1 and a threshold of ½ the paint ends there.</source>
        <translation>Densité ρ au cœur du remplissage. Sur son contour, elle en est la moitié : avec 1 et un seuil de ½, la peinture s’arrête là.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>What the stroke encloses was wetted at once, and spreads like its paint</source>
        <translation>Ce que le trait entoure a été mouillé d’un coup, et s’étale comme sa peinture</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Intérieur</translation>
    </message>
    <message>
        <source>All that is enclosed</source>
        <translation>Tout ce qui est entouré</translation>
    </message>
    <message>
        <source>Every other area</source>
        <translation>Une surface sur deux</translation>
    </message>
    <message>
        <source>What is inside where the outline overlaps itself (nonzero and even-odd in SVG)</source>
        <translation>Ce qui est à l’intérieur là où le contour se chevauche (nonzero et evenodd en SVG)</translation>
    </message>
    <message>
        <source>Change fill</source>
        <translation>Changer le remplissage</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Supprimer le remplissage</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
</context>
<context>
    <name>suffuse::VaryDialog</name>
    <message>
        <source>Vary at Random</source>
        <translation>Varier au hasard</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Varier</translation>
    </message>
    <message>
        <source>D becomes greater by up to this, or smaller by the same factor</source>
        <translation>D grandit d’autant au plus, ou diminue du même facteur</translation>
    </message>
    <message>
        <source>φ becomes greater by up to this, or smaller by the same factor</source>
        <translation>φ grandit d’autant au plus, ou diminue du même facteur</translation>
    </message>
    <message>
        <source>t_max becomes greater by up to this, or smaller by the same factor</source>
        <translation>t_max grandit d’autant au plus, ou diminue du même facteur</translation>
    </message>
    <message>
        <source>So much more grain, or less</source>
        <translation>Jusqu’à autant de grain en plus ou en moins</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Colours turn by up to this angle, either way</source>
        <translation>Les couleurs tournent de cet angle au plus, dans un sens ou dans l’autre</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Clarté</translation>
    </message>
    <message>
        <source>Colours get lighter or darker by up to this</source>
        <translation>Les couleurs s’éclaircissent ou foncent d’autant au plus</translation>
    </message>
    <message>
        <source>So much more opaque, or less</source>
        <translation>Jusqu’à autant d’opacité en plus ou en moins</translation>
    </message>
    <message>
        <source>Roll Again</source>
        <translation>Relancer</translation>
    </message>
    <message>
        <source>Other random values by the same amounts</source>
        <translation>D’autres valeurs au hasard, des mêmes quantités</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>Chaque trait</translation>
    </message>
    <message>
        <source>Each segment</source>
        <translation>Chaque segment</translation>
    </message>
    <message>
        <source>Along each stroke</source>
        <translation>Le long de chaque trait</translation>
    </message>
    <message>
        <source>What gets a random value of its own; along a stroke values drift smoothly</source>
        <translation>Ce qui reçoit sa propre valeur au hasard ; le long d’un trait, les valeurs dérivent en douceur</translation>
    </message>
    <message>
        <source>Of its own</source>
        <translation>En propre</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Over this length along a stroke values become others</source>
        <translation>Longueur, le long d’un trait, sur laquelle les valeurs changent</translation>
    </message>
</context>
<context>
    <name>suffuse::WishFields</name>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>What is painted onto the segments</source>
        <translation>Ce qui est peint sur les segments</translation>
    </message>
    <message>
        <source>Towards a value, or from the value that each segment has</source>
        <translation>Vers une valeur, ou à partir de celle qu’a chaque segment</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>What a segment has when it got all of it</source>
        <translation>Ce qu’a un segment quand il a tout reçu</translation>
    </message>
    <message>
        <source>set to</source>
        <translation>fixer à</translation>
    </message>
    <message>
        <source>multiply by</source>
        <translation>multiplier par</translation>
    </message>
    <message>
        <source>add</source>
        <translation>ajouter</translation>
    </message>
    <message>
        <source>the current colour</source>
        <translation>la couleur actuelle</translation>
    </message>
</context>
<context>
    <name>suffuse::GradientRows</name>
    <message>
        <source>Gradient</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>The fill&apos;s colour fades from left to right. The Segments tool drags the ends.</source>
        <translation>La couleur du remplissage se fond de gauche à droite. L’outil Segments en déplace les extrémités.</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Ajouter un dégradé</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Échanger</translation>
    </message>
    <message>
        <source>The two colours change places</source>
        <translation>Les deux couleurs échangent leurs places</translation>
    </message>
    <message>
        <source>Swap colours of gradient</source>
        <translation>Échanger les couleurs du dégradé</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>The fill has its first colour everywhere</source>
        <translation>Le remplissage a partout sa première couleur</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Supprimer le dégradé</translation>
    </message>
    <message>
        <source>The second colour of the gradient</source>
        <translation>La seconde couleur du dégradé</translation>
    </message>
    <message>
        <source>Change gradient</source>
        <translation>Changer le dégradé</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
</context>
<context>
    <name>ColourPicker</name>
    <message>
        <source>Beside the canvas there is no paint to take a colour from, unless paint beyond the canvas is shown.</source>
        <translation>À côté du canevas, il n’y a pas de peinture où prélever une couleur, sauf si la peinture hors du canevas est affichée.</translation>
    </message>
</context>
<context>
    <name>GradientHandles</name>
    <message>
        <source>Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.</source>
        <translation>Tirer une extrémité du dégradé. Ctrl : pas de 15°. Cliquer dessus : les couleurs sont pour elle.</translation>
    </message>
    <message>
        <source>Move gradient</source>
        <translation>Déplacer le dégradé</translation>
    </message>
</context>
<context>
    <name>suffuse::PenTool</name>
    <message>
        <source>Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.</source>
        <translation>Clic : angle. Glisser : courbe, Alt : une seule poignée. Premier nœud : fermer. Entrée : finir. Retour arrière : reculer.</translation>
    </message>
    <message>
        <source>Click or drag to go on with the selected stroke from its end.</source>
        <translation>Cliquer ou glisser pour continuer le trait sélectionné depuis son extrémité.</translation>
    </message>
    <message>
        <source>Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.</source>
        <translation>Clic : angle ; glisser : courbe. Maj : pas de 15°. Extrémité d’un trait sélectionné : le continuer.</translation>
    </message>
    <message>
        <source>Extend outline</source>
        <translation>Prolonger le contour</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
</context>
<context>
    <name>suffuse::LassoFillTool</name>
    <message>
        <source>Click: straight line. First point, double click or Return: close. Shift: steps of 15°.</source>
        <translation>Clic : ligne droite. Premier point, double-clic ou Entrée : fermer. Maj : pas de 15°.</translation>
    </message>
    <message>
        <source>Draw around what is to be filled. Alt at the end, or clicks: straight lines.</source>
        <translation>Entourer ce qui est à remplir. Alt à la fin, ou clics : lignes droites.</translation>
    </message>
    <message>
        <source>Lasso fill</source>
        <translation>Remplissage au lasso</translation>
    </message>
</context>
<context>
    <name>suffuse::BucketTool</name>
    <message>
        <source>Click: fill what the paint around that place bounds, with the brush in hand.</source>
        <translation>Clic : remplir ce que délimite la peinture autour de cet endroit, avec le pinceau en main.</translation>
    </message>
    <message>
        <source>Over all strokes</source>
        <translation>Par-dessus tous les traits</translation>
    </message>
    <message>
        <source>Under all strokes</source>
        <translation>Sous tous les traits</translation>
    </message>
    <message>
        <source>Where the fill lies</source>
        <translation>Où se trouve le remplissage</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>By how much colours may differ from that under the pointer</source>
        <translation>De combien les couleurs peuvent différer de celle sous le pointeur</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Vides</translation>
    </message>
    <message>
        <source>Openings of the bounds that are narrower are closed</source>
        <translation>Les ouvertures de la limite plus étroites que cela sont fermées</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Agrandir de</translation>
    </message>
    <message>
        <source>How far the fill reaches under its bounds</source>
        <translation>De combien le remplissage déborde sous sa limite</translation>
    </message>
    <message>
        <source>Only what lies on the canvas is filled.</source>
        <translation>Seul ce qui est sur le canevas est rempli.</translation>
    </message>
    <message>
        <source>There is nothing to fill here.</source>
        <translation>Il n’y a rien à remplir ici.</translation>
    </message>
    <message>
        <source>Bucket fill</source>
        <translation>Remplissage au seau</translation>
    </message>
    <message>
        <source>Looking for what the paint bounds there. Esc gives it up.</source>
        <translation>Recherche de ce que la peinture délimite là. Échap abandonne.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile: nothing was filled.</source>
        <translation>Le tableau a changé entre-temps : rien n’a été rempli.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextEntry</name>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
</context>
<context>
    <name>suffuse::TextTool</name>
    <message>
        <source>Something in this text is locked: unlock it to change the text.</source>
        <translation>Une partie de ce texte est verrouillée : déverrouillez-la pour changer le texte.</translation>
    </message>
    <message>
        <source>The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or type on: new letters are those of a font like it.</source>
        <translation>La police « %1 » n’est pas installée ici : ces lettres restent telles quelles. Choisissez-en une autre, ou continuez à taper : les nouvelles lettres auront une police proche.</translation>
    </message>
    <message>
        <source>Type. Return: a new line. Esc or a click elsewhere: done.</source>
        <translation>Tapez. Entrée : nouvelle ligne. Échap ou un clic ailleurs : terminé.</translation>
    </message>
    <message>
        <source>Click or Return: type a text, or in the text that is there.</source>
        <translation>Clic ou Entrée : saisir un texte, ou modifier celui qui est là.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextRow</name>
    <message>
        <source>Font</source>
        <translation>Police</translation>
    </message>
    <message>
        <source>Font: it is not installed here, and another one stands in</source>
        <translation>Police : elle n’est pas installée ici, et une autre la remplace</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Léger</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Moyen</translation>
    </message>
    <message>
        <source>Semibold</source>
        <translation>Demi-gras</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Gras</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>How strong the letters are</source>
        <translation>L’épaisseur des lettres</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>Italique</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>The em of the font</source>
        <translation>Le cadratin de la police</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Room that is added between letters, of the size</source>
        <translation>Espace ajouté entre les lettres, par rapport à la taille</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Interligne</translation>
    </message>
    <message>
        <source>From one line to the next, of the size</source>
        <translation>D’une ligne à la suivante, par rapport à la taille</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Where lines lie: they begin at the text&apos;s place, are centred on it, or end there</source>
        <translation>Où se placent les lignes : elles commencent à l’endroit du texte, y sont centrées ou y finissent</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Lines run from top to bottom, and follow each other from right to left</source>
        <translation>Les lignes vont de haut en bas, et se suivent de droite à gauche</translation>
    </message>
    <message>
        <source>On Selected Stroke</source>
        <translation>Sur le trait sélectionné</translation>
    </message>
    <message>
        <source>Set the text along the selected stroke, which it follows from then on</source>
        <translation>Placer le texte le long du trait sélectionné, qu’il suit dès lors</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Droit</translation>
    </message>
    <message>
        <source>Take the text off its curve</source>
        <translation>Détacher le texte de sa courbe</translation>
    </message>
</context>
<context>
    <name>suffuse::TextValues</name>
    <message>
        <source>Change text</source>
        <translation>Changer le texte</translation>
    </message>
</context>
<context>
    <name>suffuse::BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Incrustation</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Obscurcir</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Colour Dodge</source>
        <translation>Densité couleur -</translation>
    </message>
    <message>
        <source>Colour Burn</source>
        <translation>Densité couleur +</translation>
    </message>
    <message>
        <source>Hard Light</source>
        <translation>Lumière crue</translation>
    </message>
    <message>
        <source>Soft Light</source>
        <translation>Lumière douce</translation>
    </message>
    <message>
        <source>Difference</source>
        <comment>blend mode</comment>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <comment>blend mode</comment>
        <translation>Exclusion</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Luminosité</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addition</translation>
    </message>
    <message>
        <source>Mask Below</source>
        <translation>Masquer le dessous</translation>
    </message>
    <message>
        <source>Erase Below</source>
        <translation>Effacer le dessous</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Écrêter par le dessous</translation>
    </message>
    <message>
        <source>The group covers what lies below.</source>
        <translation>Le groupe couvre ce qui est dessous.</translation>
    </message>
    <message>
        <source>Darkens, as glazes and shadows do; white changes nothing.</source>
        <translation>Assombrit, comme les glacis et les ombres ; le blanc ne change rien.</translation>
    </message>
    <message>
        <source>Lightens, as lights do that fall on one place; black changes nothing.</source>
        <translation>Éclaircit, comme des lumières qui tombent au même endroit ; le noir ne change rien.</translation>
    </message>
    <message>
        <source>Multiplies where it is dark below, and screens where it is light there.</source>
        <translation>Applique Produit là où c’est sombre dessous, et Écran là où c’est clair.</translation>
    </message>
    <message>
        <source>Of each channel the darker value stays.</source>
        <translation>De chaque canal, la valeur la plus sombre reste.</translation>
    </message>
    <message>
        <source>Of each channel the lighter value stays.</source>
        <translation>De chaque canal, la valeur la plus claire reste.</translation>
    </message>
    <message>
        <source>Brightens what lies below, strongly where the group is light.</source>
        <translation>Avive ce qui est dessous, fortement là où le groupe est clair.</translation>
    </message>
    <message>
        <source>Deepens what lies below, strongly where the group is dark.</source>
        <translation>Renforce ce qui est dessous, fortement là où le groupe est sombre.</translation>
    </message>
    <message>
        <source>Multiplies where the group is dark, and screens where it is light.</source>
        <translation>Applique Produit là où le groupe est sombre, et Écran là où il est clair.</translation>
    </message>
    <message>
        <source>Darkens or lightens gently, as a diffuse light does.</source>
        <translation>Assombrit ou éclaircit doucement, comme une lumière diffuse.</translation>
    </message>
    <message>
        <source>How far both are apart; white inverts what lies below.</source>
        <translation>L’écart entre les deux ; le blanc inverse ce qui est dessous.</translation>
    </message>
    <message>
        <source>As Difference, with less contrast.</source>
        <translation>Comme Différence, avec moins de contraste.</translation>
    </message>
    <message>
        <source>The hue of the group, with saturation and luminosity of what lies below.</source>
        <translation>La teinte du groupe, avec la saturation et la luminosité de ce qui est dessous.</translation>
    </message>
    <message>
        <source>The saturation of the group, with hue and luminosity of what lies below.</source>
        <translation>La saturation du groupe, avec la teinte et la luminosité de ce qui est dessous.</translation>
    </message>
    <message>
        <source>Hue and saturation of the group, with the luminosity of what lies below: for tinting.</source>
        <translation>La teinte et la saturation du groupe, avec la luminosité de ce qui est dessous : pour teinter.</translation>
    </message>
    <message>
        <source>The luminosity of the group, with hue and saturation of what lies below.</source>
        <translation>La luminosité du groupe, avec la teinte et la saturation de ce qui est dessous.</translation>
    </message>
    <message>
        <source>The sum of both, for glows (plus, linear dodge).</source>
        <translation>La somme des deux, pour les lueurs (plus, densité linéaire -).</translation>
    </message>
    <message>
        <source>The group is not seen itself: what lies below stays where the group covers, and goes elsewhere (destination-in).</source>
        <translation>Le groupe lui-même n’est pas visible : ce qui est dessous reste là où il couvre, et disparaît ailleurs (destination-in).</translation>
    </message>
    <message>
        <source>The group is not seen itself: it takes away what lies below where it covers (destination-out).</source>
        <translation>Le groupe lui-même n’est pas visible : il enlève ce qui est dessous là où il couvre (destination-out).</translation>
    </message>
    <message>
        <source>The group is seen only where paint lies below it: for shading a shape without leaving it (source-atop).</source>
        <translation>Le groupe n’est visible que là où il y a de la peinture dessous : pour ombrer une forme sans en sortir (source-atop).</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupSection</name>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap in it do not show through each other.</source>
        <translation>Avec quelle force le groupe apparaît. Au-dessous de 100 %, il pâlit dans son ensemble : les traits qui s’y chevauchent ne transparaissent pas l’un à travers l’autre.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Changer l’opacité du groupe</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Impossible pour toute la sélection : une valeur serait hors limites.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Changer le mode du groupe</translation>
    </message>
    <message>
        <source>Mix by itself</source>
        <translation>Mélanger à part</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Mélanger le groupe à part</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Mélanger le groupe à ce qui est dessous</translation>
    </message>
    <message>
        <source>How the group&apos;s picture is put on what lies below. Any mode but Normal has its strokes mix by themselves first.</source>
        <translation>Comment l’image du groupe est posée sur ce qui est dessous. Tout mode sauf Normal fait d’abord se mélanger ses traits à part.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>the mode that is chosen, and what it does</extracomment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>The group&apos;s strokes mix among themselves, and their picture is put on what lies below. Otherwise they mix with what lies below as if there were no group.</source>
        <translation>Les traits du groupe se mélangent entre eux, et leur image est posée sur ce qui est dessous. Sinon, ils se mélangent à ce qui est dessous comme s’il n’y avait pas de groupe.</translation>
    </message>
    <message>
        <source>Clip to below</source>
        <translation>Écrêter par le dessous</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Lavis</translation>
    </message>
    <message>
        <source>The group is seen only where the next thing below it in the same group is: for shading a shape without leaving it.</source>
        <translation>Le groupe n’est visible que là où se trouve l’élément juste en dessous dans le même groupe : pour ombrer une forme sans en sortir.</translation>
    </message>
    <message>
        <source>The group is not seen itself; what else is in the same group is seen only where it has paint.</source>
        <translation>Le groupe lui-même n’est pas visible ; le reste du même groupe ne l’est que là où il a de la peinture.</translation>
    </message>
    <message>
        <source>All strokes of the group are one, laid wet into wet: their densities add up, with one style and one mixing. Filled strokes, hidden ones and those of a mask within it stay by themselves.</source>
        <translation>Tous les traits du groupe ne font qu’un, posés mouillé sur mouillé : leurs densités s’additionnent, avec un seul style et un seul mélange. Traits remplis, masqués ou d’un masque à l’intérieur restent à part.</translation>
    </message>
    <message>
        <source>There is nothing below it to clip to.</source>
        <translation>Il n’y a rien en dessous par quoi l’écrêter.</translation>
    </message>
    <message>
        <source>There is nothing beside it to mask.</source>
        <translation>Il n’y a rien à côté à masquer.</translation>
    </message>
    <message>
        <source>It is in a wash already.</source>
        <translation>Il est déjà dans un lavis.</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Marque</translation>
    </message>
    <message>
        <source>A colour that marks the group for you, in lists. It is not seen in the picture.</source>
        <translation>Une couleur qui marque le groupe pour vous, dans les listes. Elle n’apparaît pas dans l’image.</translation>
    </message>
    <message>
        <source>Mark group</source>
        <translation>Marquer le groupe</translation>
    </message>
    <message>
        <source>The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a mask.</source>
        <translation>Le groupe se mélange à part de toute façon : par son opacité ou son mode, ou parce qu’il est écrêté ou sert de masque.</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Ébauche</translation>
    </message>
    <message>
        <source>The group is seen here, and left out of pictures and films that are exported: for sketches and pictures to paint over.</source>
        <translation>Le groupe est visible ici, et omis des images et films exportés : pour les esquisses et les images sur lesquelles peindre.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupTag</name>
    <message>
        <source>None</source>
        <comment>mark of a group</comment>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Red</source>
        <comment>mark of a group</comment>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Orange</source>
        <comment>mark of a group</comment>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <comment>mark of a group</comment>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>Green</source>
        <comment>mark of a group</comment>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <comment>mark of a group</comment>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Violet</source>
        <comment>mark of a group</comment>
        <translation>Violet</translation>
    </message>
    <message>
        <source>Brown</source>
        <comment>mark of a group</comment>
        <translation>Marron</translation>
    </message>
    <message>
        <source>Grey</source>
        <comment>mark of a group</comment>
        <translation>Gris</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>%1: the linked picture is missing or has changed. Put it back, or link it anew in the Inspector.</source>
        <translation>%1 : l’image liée manque ou a changé. Remettez-la, ou liez-la de nouveau dans l’inspecteur.</translation>
    </message>
    <message>
        <source>the image of a picture is missing</source>
        <translation>le fichier d’une image manque</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>image</translation>
    </message>
</context>
<context>
    <name>LayeredFile</name>
    <message>
        <source>%1: Photoshop files have at most 2 GB. Choose a smaller size, or OpenRaster.</source>
        <translation>%1 : les fichiers Photoshop font au plus 2 Go. Choisissez une taille plus petite, ou OpenRaster.</translation>
    </message>
    <message>
        <source>%1: Photoshop files have at most %2 pixels a side. Choose a smaller size, or OpenRaster.</source>
        <translation>%1 : les fichiers Photoshop ont au plus %2 pixels par côté. Choisissez une taille plus petite, ou OpenRaster.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>arrêté ; rien n’a été écrit</translation>
    </message>
    <message>
        <source>The file could not be packed.</source>
        <translation>Le fichier n’a pas pu être compressé.</translation>
    </message>
</context>
<context>
    <name>ImageLayer</name>
    <message>
        <source>%1: the pictures of a painting may have %2 million pixels together, and this one would be too many. Scale it down, or remove another one.</source>
        <translation>%1 : les images d’un tableau peuvent avoir ensemble %2 millions de pixels, et celle-ci serait de trop. Réduisez-la, ou supprimez-en une autre.</translation>
    </message>
    <message>
        <source>Import picture</source>
        <translation>Importer une image</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The picture of the clipboard cannot be read.</source>
        <translation>L’image du presse-papiers ne peut pas être lue.</translation>
    </message>
    <message>
        <source>Paste picture</source>
        <translation>Coller une image</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Underlay to layer</source>
        <translation>Modèle en calque</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Lier l’image</translation>
    </message>
    <message>
        <source>Embed picture</source>
        <translation>Incorporer l’image</translation>
    </message>
    <message>
        <source>Reset proportions</source>
        <translation>Rétablir les proportions</translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Linked to a file</source>
        <translation>Liée à un fichier</translation>
    </message>
    <message>
        <source>The painting names the picture&apos;s file, and does not hold the picture itself. Otherwise the picture is in the painting, whatever becomes of the file.</source>
        <translation>Le tableau nomme le fichier de l’image et ne contient pas l’image elle-même. Sinon, l’image est dans le tableau, quoi que devienne le fichier.</translation>
    </message>
    <message>
        <source>Relink…</source>
        <translation>Lier à nouveau…</translation>
    </message>
    <message>
        <source>Another file, or the same one where it lies now, in the picture&apos;s place</source>
        <translation>Un autre fichier, ou le même là où il se trouve maintenant, à la place de l’image</translation>
    </message>
    <message>
        <source>Reset Proportions</source>
        <translation>Rétablir les proportions</translation>
    </message>
    <message>
        <source>As high and wide as its pixels ask for: its top left corner, its direction and its width stay.</source>
        <translation>Aussi haute et large que ses pixels le demandent : son coin supérieur gauche, sa direction et sa largeur ne changent pas.</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Lier l’image</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is missing or has changed, and is not seen.</source>
        <translation>%1 manque ou a changé, et n’est pas affiché.</translation>
    </message>
    <message>
        <source>A picture is missing, and is not seen.</source>
        <translation>Une image manque, et n’est pas affichée.</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>interrompu ; rien n’a été écrit</translation>
    </message>
    <message>
        <source>the sheet is too large for a picture with a pixel a unit</source>
        <translation>la feuille est trop grande pour une image d’un pixel par unité</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG n’a pas de groupes qui effacent ce qui est dessous : %n groupe est devenu ordinaire.</numerusform>
            <numerusform>SVG n’a pas de groupes qui effacent ce qui est dessous : %n groupes sont devenus ordinaires.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>%n trait est omis, car rien n’en est assez couvert pour avoir un chemin.</numerusform>
            <numerusform>%n traits sont omis, car rien n’en est assez couvert pour avoir un chemin.</numerusform>
        </translation>
    </message>
    <message>
        <source>The drawing differs from the picture by at most %1 of 255, by %2 on average.</source>
        <translation>Le dessin diffère de l’image d’au plus %1 sur 255, de %2 en moyenne.</translation>
    </message>
    <message>
        <source>%1: would have %2 MB once it is unpacked, and could not be opened again. Choose fewer bands, or the ending .svg.</source>
        <translation>%1 : ferait %2 Mo une fois décompressé, et ne pourrait plus être ouvert. Choisissez moins de bandes, ou l’extension .svg.</translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF n’a pas de groupes qui effacent ce qui est dessous, ou s’y ajoutent : %n groupe est devenu ordinaire.</numerusform>
            <numerusform>PDF n’a pas de groupes qui effacent ce qui est dessous, ou s’y ajoutent : %n groupes sont devenus ordinaires.</numerusform>
        </translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingDialog</name>
    <message>
        <source>One path for each stroke, where it is covered by half: for plotters, cutters, logos.</source>
        <translation>Un chemin pour chaque trait, là où il couvre à moitié : pour traceurs, découpeuses, logos.</translation>
    </message>
    <message>
        <source>Contours within each other, as opaque as the paint. They look like the painting at any zoom.</source>
        <translation>Contours emboîtés, aussi opaques que la peinture. Ils ressemblent au tableau à tout zoom.</translation>
    </message>
    <message>
        <source>The exact picture, a pixel a unit, and over it the outlines without paint, to select and name strokes by.</source>
        <translation>L’image exacte, un pixel par unité, et par-dessus les contours sans peinture, pour sélectionner et nommer les traits.</translation>
    </message>
    <message>
        <source>Export Drawing</source>
        <translation>Exporter un dessin</translation>
    </message>
    <message>
        <source>The ending chooses the format: svg, svgz, which is packed, or pdf.</source>
        <translation>L’extension choisit le format : svg, svgz (compressé) ou pdf.</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Bandes</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
    <message>
        <source>Picture and outlines</source>
        <translation>Image et contours</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What of the painting becomes paths</source>
        <translation>Ce qui, du tableau, devient des chemins</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Paliers</translation>
    </message>
    <message>
        <source>How many bands full opacity is drawn in. More of them are smoother, and make a larger file.</source>
        <translation>En combien de bandes l’opacité totale est dessinée. Plus il y en a, plus c’est lisse, et plus le fichier est gros.</translation>
    </message>
    <message>
        <source>Of red, green and blue, over the sheet, with a pixel a unit</source>
        <translation>Du rouge, du vert et du bleu, sur la feuille, à un pixel par unité</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Comparing with the picture…</source>
        <translation>Comparaison avec l’image…</translation>
    </message>
    <message>
        <source>It is exported as soon as it is compared with the picture.</source>
        <translation>L’exportation se fait dès que la comparaison avec l’image est finie.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnue</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Dessins</translation>
    </message>
    <message>
        <source>“%1” has no ending of a drawing. Choose one of: %2.</source>
        <translation>« %1 » n’a pas d’extension de dessin. Choisissez-en une : %2.</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>Aussi grande que la feuille</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where that is not said, has 96 units an inch.</source>
        <translation>D’un PDF : la feuille s’inscrit dans la page, en son milieu. D’elle-même, elle est aussi grande que sur papier ou, si cela n’est pas dit, a 96 unités par pouce.</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingJob</name>
    <message>
        <source>The drawing does not fit into memory.</source>
        <translation>Le dessin ne tient pas en mémoire.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln ligne</numerusform>
            <numerusform>%Ln lignes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ColourProfile</name>
    <message>
        <source>it is no ICC profile of RGB, grey or CMYK</source>
        <translation>ce n’est pas un profil ICC de RVB, de gris ou de CMJN</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is too large</source>
        <translation>%1 : lecture impossible, ou fichier trop grand</translation>
    </message>
</context>
<context>
    <name>suffuse::Proofing</name>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Profil de l’épreuve à l’écran</translation>
    </message>
    <message>
        <source>Colours not converted</source>
        <translation>Couleurs non converties</translation>
    </message>
    <message>
        <source>Proof: %1</source>
        <translation>Épreuve : %1</translation>
    </message>
</context>
<context>
    <name>ChooseProfile</name>
    <message>
        <source>Colour profiles</source>
        <translation>Profils de couleur</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPage</name>
    <message>
        <source>That of the system</source>
        <translation>Celui du système</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>Aucun (sRGB)</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>D’un fichier</translation>
    </message>
    <message>
        <source>Screen profile</source>
        <translation>Profil de l’écran</translation>
    </message>
    <message>
        <source>What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were meant.</source>
        <translation>Ce que l’écran fait de ses valeurs. Le canevas y est converti, pour que les couleurs aient l’aspect voulu.</translation>
    </message>
    <message>
        <source>Screen profile file</source>
        <translation>Fichier de profil de l’écran</translation>
    </message>
    <message>
        <source>Chooses the ICC profile that was measured for this screen</source>
        <translation>Choisit le profil ICC qui a été mesuré pour cet écran</translation>
    </message>
    <message>
        <source>Soft proof</source>
        <translation>Épreuve à l’écran</translation>
    </message>
    <message>
        <source>Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left there.</source>
        <translation>Choisit le profil ICC d’une presse ou d’une imprimante. Affichage ▸ Épreuve à l’écran montre les couleurs qu’il y reste.</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perception</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Colorimétrie relative</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Colorimétrie absolue</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Mode de rendu</translation>
    </message>
    <message>
        <source>What becomes of colours that the device of the soft proof does not have</source>
        <translation>Ce que deviennent les couleurs que le périphérique de l’épreuve n’a pas</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>Compensation du point noir</translation>
    </message>
    <message>
        <source>The darkest colour becomes the darkest one that the device has</source>
        <translation>La couleur la plus sombre devient la plus sombre du périphérique</translation>
    </message>
    <message>
        <source>Profile of the Screen</source>
        <translation>Profil de l’écran</translation>
    </message>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Profil de l’épreuve à l’écran</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
</context>
<context>
    <name>suffuse::ProfileBox</name>
    <message>
        <source>The painting&apos;s profile</source>
        <translation>Le profil du tableau</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>%1: the profile is too large to be kept in a painting. Choose a smaller one.</source>
        <translation>%1 : le profil est trop grand pour être gardé dans un tableau. Choisissez-en un plus petit.</translation>
    </message>
    <message>
        <source>%1: %2. Choose a profile of RGB colours.</source>
        <translation>%1 : %2. Choisissez un profil de couleurs RVB.</translation>
    </message>
    <message>
        <source>Profile of the Colours</source>
        <translation>Profil des couleurs</translation>
    </message>
</context>
<context>
    <name>suffuse::FitJob</name>
    <message>
        <source>%1: there is not enough memory to fit it.</source>
        <translation>%1 : mémoire insuffisante pour l’ajuster.</translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message>
        <source>Ground</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>Picture to strokes</source>
        <translation>Image en traits</translation>
    </message>
    <message>
        <source>The picture was painted quickly, just before the moment that you look at. All that you painted stays as it is.</source>
        <translation>L’image a été peinte rapidement, juste avant le moment que vous regardez. Tout ce que vous avez peint reste tel quel.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>%Ln trait a été ajouté, avec un fond en dessous.</numerusform>
            <numerusform>%Ln traits ont été ajoutés, avec un fond en dessous.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitView</name>
    <message>
        <source>Picture made of strokes</source>
        <translation>Image faite de traits</translation>
    </message>
    <message>
        <source>What the strokes look like. While a mouse button is held on it, the original is seen.</source>
        <translation>Ce à quoi ressemblent les traits. Tant qu’un bouton de souris y est maintenu, on voit l’original.</translation>
    </message>
    <message>
        <source>Here the picture grows, stroke by stroke.</source>
        <translation>Ici, l’image grandit, trait après trait.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitRows</name>
    <message>
        <source>Strokes</source>
        <translation>Traits</translation>
    </message>
    <message>
        <source>At most so many. More of them go on with those that are there; fewer begin anew.</source>
        <translation>Nombre maximal. L’augmenter continue avec les traits présents ; le réduire recommence tout.</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Détail</translation>
    </message>
    <message>
        <source>How much is done for each stroke. Better goes on with what is there.</source>
        <translation>L’effort fait pour chaque trait. Un meilleur niveau continue ce qui est là.</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bon</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Optimal</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Style</translation>
    </message>
    <message>
        <source>Of all strokes. Another one begins anew.</source>
        <translation>De tous les traits. En changer recommence tout.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Each stroke its own, or a few paints, which become linked swatches</source>
        <translation>À chaque trait la sienne, ou quelques peintures, qui deviennent des nuances liées</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Few paints</source>
        <translation>Quelques peintures</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Peintures</translation>
    </message>
    <message>
        <source>So many colours in all</source>
        <translation>Nombre de couleurs en tout</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Widths of strokes, and the roll of the dice</source>
        <translation>Largeurs des traits, et le hasard</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>Largeur minimale</translation>
    </message>
    <message>
        <source>No stroke is narrower; 0: as narrow as it likes</source>
        <translation>Aucun trait n’est plus étroit ; 0 : sans limite</translation>
    </message>
    <message>
        <source>Greatest width</source>
        <translation>Largeur maximale</translation>
    </message>
    <message>
        <source>No stroke is wider; 0: as wide as it likes</source>
        <translation>Aucun trait n’est plus large ; 0 : sans limite</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Another number gives other strokes, equally good ones</source>
        <translation>Un autre nombre donne d’autres traits, tout aussi bons</translation>
    </message>
    <message>
        <source>The greatest width is below the least one.</source>
        <translation>La largeur maximale est inférieure à la minimale.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message>
        <source>far: %1 dB</source>
        <translation>loin : %1 dB</translation>
    </message>
    <message>
        <source>roughly: %1 dB</source>
        <translation>approximatif : %1 dB</translation>
    </message>
    <message>
        <source>near: %1 dB</source>
        <translation>proche : %1 dB</translation>
    </message>
    <message>
        <source>very near: %1 dB</source>
        <translation>très proche : %1 dB</translation>
    </message>
    <message>
        <source>Picture to Strokes</source>
        <translation>Image en traits</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>Où en est le travail</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Shows the picture itself: while held, or click to switch back and forth.</source>
        <translation>Montre l’image elle-même : maintenir, ou cliquer pour basculer.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Which picture becomes strokes</source>
        <translation>Quelle image devient des traits</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aucune encore</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fichier…</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insérer</translation>
    </message>
    <message>
        <source>Puts the strokes so far into the painting, as a layer</source>
        <translation>Met dans le tableau les traits faits jusqu’ici, comme calque</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stops the work, or goes on with it</source>
        <translation>Arrête le travail, ou le continue</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Lecture de l’image…</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>off by %1 of 255</source>
        <translation>écart de %1 sur 255</translation>
    </message>
    <message>
        <source>Fewer Strokes</source>
        <translation>Moins de traits</translation>
    </message>
    <message>
        <source>What the strokes are to look like: as those that are there do, or as a picture of the whole sheet</source>
        <translation>À quoi les traits doivent ressembler : à ceux qui sont là, ou à une image de toute la feuille</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>Tels qu’ils sont</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Puts the strokes so far in place of the selected ones</source>
        <translation>Met les traits faits jusqu’ici à la place des traits sélectionnés</translation>
    </message>
    <message>
        <source>Give up the strokes so far?</source>
        <translation>Abandonner les traits faits jusqu’ici ?</translation>
    </message>
    <message>
        <source>Replace puts them in place of the selected ones.</source>
        <translation>Remplacer les met à la place des traits sélectionnés.</translation>
    </message>
    <message>
        <source>Insert puts them into the painting.</source>
        <translation>Insérer les met dans le tableau.</translation>
    </message>
    <message>
        <source>&amp;Give Up</source>
        <translation>&amp;Abandonner</translation>
    </message>
</context>
<context>
    <name>fitting</name>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>%1: is black all over, so nothing counts; paint white what is to be fitted</source>
        <translation>%1 : est noire partout, rien ne compte donc ; peignez en blanc ce qui est à ajuster</translation>
    </message>
    <message>
        <source>its canvas has %1 × %2 units, and the picture %3 × %4 pixels; go on with a painting that was fitted to this picture</source>
        <translation>son canevas a %1 × %2 unités, et l’image %3 × %4 pixels ; continuez avec un tableau ajusté à cette image</translation>
    </message>
    <message>
        <source>stroke %1: %2; a fit goes on with what a fit made</source>
        <translation>trait %1 : %2 ; un ajustement continue ce qu’un ajustement a fait</translation>
    </message>
</context>
<context>
    <name>curves</name>
    <message>
        <source>its picture has %1 × %2 pixels; image_width and image_height must be 1 at least</source>
        <translation>son image a %1 × %2 pixels ; image_width et image_height doivent être d’au moins 1</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to solve</source>
        <translation>ne contient pas de courbes ; il n’y a rien à résoudre</translation>
    </message>
</context>
<context>
    <name>refit</name>
    <message>
        <source>none of the strokes is visible and unlocked; choose others</source>
        <translation>aucun des traits n’est visible et déverrouillé ; choisissez-en d’autres</translation>
    </message>
    <message>
        <source>the strokes lie beside the sheet, where nothing is seen of them</source>
        <translation>les traits sont à côté de la feuille, où l’on n’en voit rien</translation>
    </message>
    <message>
        <source>the strokes of group “%1” mix in their own way; choose all of them that are visible, or none of them</source>
        <translation>les traits du groupe « %1 » se mélangent à leur façon ; choisissez tous ceux qui sont visibles, ou aucun</translation>
    </message>
    <message>
        <source>group “%1” is a wash, whose strokes are one; make it a group like others first</source>
        <translation>le groupe « %1 » est un lavis, dont les traits ne font qu’un ; faites-en d’abord un groupe ordinaire</translation>
    </message>
    <message>
        <source>%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape of the sheet</source>
        <translation>%1 : a les proportions %2 × %3, et la feuille %4 × %5 ; recadrez-la aux proportions de la feuille</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>the strokes are in a group that is put on the others as one picture, so no picture of the whole says how they should look; make it a group like others first</source>
        <translation>les traits sont dans un groupe posé sur les autres en une seule image, aucune image de l’ensemble ne dit donc leur aspect ; faites-en d’abord un groupe ordinaire</translation>
    </message>
    <message>
        <source>other strokes hide the chosen ones wholly; choose others, or hide what lies above</source>
        <translation>d’autres traits cachent entièrement ceux choisis ; choisissez-en d’autres, ou masquez ce qui est au-dessus</translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message>
        <source>There the picture is off by %1 of 255 (root mean square), %2 at most.</source>
        <translation>L’image s’y écarte de %1 sur 255 (moyenne quadratique), de %2 au plus.</translation>
    </message>
    <message>
        <source>Fewer strokes</source>
        <translation>Moins de traits</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>au lieu de %Ln.</numerusform>
            <numerusform>au lieu de %Ln.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%Ln trait qui se trouvait entre eux est maintenant dessous.</numerusform>
            <numerusform>%Ln traits qui se trouvaient entre eux sont maintenant dessous.</numerusform>
        </translation>
    </message>
    <message>
        <source>That is farther than before, when it was off by %1; Undo brings the former strokes back.</source>
        <translation>C’est plus loin qu’avant, où l’écart était de %1 ; Annuler restaure les anciens traits.</translation>
    </message>
</context>
<context>
    <name>Tiles</name>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start again to go on.</source>
        <translation>%1 Ce que dessine un autre moteur a d’autres bits, et n’y est pas mêlé. Relancez pour continuer.</translation>
    </message>
    <message>
        <source>there is not enough memory for the sheets that are drawn at once</source>
        <translation>mémoire insuffisante pour les planches dessinées à la fois</translation>
    </message>
    <message>
        <source>a tile cannot be encoded: %1</source>
        <translation>une tuile ne peut pas être codée : %1</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2)</source>
        <translation>%1 : lecture impossible (%2)</translation>
    </message>
    <message>
        <source>%1: what is there is of another picture, or of another build or backend. Remove it, or choose another name.</source>
        <translation>%1 : ce qui s’y trouve est d’une autre image, ou d’une autre compilation ou d’un autre moteur. Supprimez-le, ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1 : écriture impossible (%2). Choisissez un autre dossier, ou modifiez ses droits d’accès.</translation>
    </message>
    <message>
        <source>%1: another program is drawing the same picture. Wait until it has finished, or choose another name.</source>
        <translation>%1 : un autre programme dessine la même image. Attendez qu’il ait fini, ou choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>suffuse::ManualWindow</name>
    <message>
        <source>Suffuse Manual</source>
        <translation>Manuel de Suffuse</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Rechercher dans le manuel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Aucun résultat</translation>
    </message>
</context>
<context>
    <name>suffuse::Lesson</name>
    <message>
        <source>Paint, and change your mind</source>
        <translation>Peindre, et changer d’avis</translation>
    </message>
    <message>
        <source>Let paint spread</source>
        <translation>Laisser la peinture s’étaler</translation>
    </message>
    <message>
        <source>Work with layers</source>
        <translation>Travailler avec des calques</translation>
    </message>
    <message>
        <source>Done. All of this can be changed at any time.</source>
        <translation>Terminé. Tout cela peut être changé à tout moment.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke on the sheet, however you like.</source>
        <translation>Appuyez sur B et dessinez un trait sur la feuille, comme bon vous semble.</translation>
    </message>
    <message>
        <source>Press V for the Select tool, and click the paint of your stroke.</source>
        <translation>Appuyez sur V pour l’outil Sélection, et cliquez sur la peinture de votre trait.</translation>
    </message>
    <message>
        <source>Choose another colour in the Colour dock. It is now about what is selected.</source>
        <translation>Choisissez une autre couleur dans le panneau Couleur. Il concerne maintenant la sélection.</translation>
    </message>
    <message>
        <source>Take it back with Ctrl+Z.</source>
        <translation>Annulez avec Ctrl+Z.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. Watch it spread after you let go.</source>
        <translation>Appuyez sur B et dessinez un trait. Regardez-le s’étaler après avoir relâché.</translation>
    </message>
    <message>
        <source>Press D: this goes to the moment when everything is dry.</source>
        <translation>Appuyez sur D : cela va au moment où tout est sec.</translation>
    </message>
    <message>
        <source>In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far.</source>
        <translation>Dans le panneau Inspecteur, faites glisser le curseur de Diffusion D. La peinture sèche s’étale plus loin, ou moins loin.</translation>
    </message>
    <message>
        <source>Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it.</source>
        <translation>Choisissez Calque ▸ Nouveau calque, ou appuyez sur Ctrl+Maj+N. Ce que vous peignez ensuite s’y place.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. The layer comes into the list with it.</source>
        <translation>Appuyez sur B et dessinez un trait. Le calque apparaît dans la liste avec lui.</translation>
    </message>
    <message>
        <source>In the row of the layer, drag its opacity to the left, or click its mode and choose another one.</source>
        <translation>Dans la ligne du calque, faites glisser son opacité vers la gauche, ou cliquez sur son mode et choisissez-en un autre.</translation>
    </message>
</context>
<context>
    <name>suffuse::LessonCard</name>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – étape %2 sur %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>Quitter la leçon</translation>
    </message>
</context>
<context>
    <name>suffuse::Sheets</name>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 in</source>
        <translation>%1 × %2 po</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Modèles de feuille</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Croquis</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Lettre US</translation>
    </message>
    <message>
        <source>Legal</source>
        <translation>Légal US</translation>
    </message>
    <message>
        <source>Tabloid</source>
        <translation>Tabloïd US</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>Carte postale</translation>
    </message>
    <message>
        <source>Watercolour sheet</source>
        <translation>Feuille d’aquarelle</translation>
    </message>
    <message>
        <source>Rice paper</source>
        <translation>Papier de riz</translation>
    </message>
    <message>
        <source>Toned paper</source>
        <translation>Papier teinté</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Nuit</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
</context>
<context>
    <name>suffuse::WelcomeDialog</name>
    <message>
        <source>Welcome to Suffuse</source>
        <translation>Bienvenue dans Suffuse</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Nouveau tableau</translation>
    </message>
    <message>
        <source>Other Size…</source>
        <translation>Autre taille…</translation>
    </message>
    <message>
        <source>Open a painting</source>
        <translation>Ouvrir un tableau</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>Trois courtes leçons</translation>
    </message>
    <message>
        <source>Show this at the start</source>
        <translation>Afficher ceci au démarrage</translation>
    </message>
    <message>
        <source>Sheets by their size. Return begins a painting on one.</source>
        <translation>Feuilles selon leur taille. Entrée commence un tableau sur l’une d’elles.</translation>
    </message>
    <message>
        <source>Recent paintings and samples. Return opens one.</source>
        <translation>Tableaux récents et exemples. Entrée en ouvre un.</translation>
    </message>
</context>
<context>
    <name>suffuse::Workspaces</name>
    <message>
        <source>Save Workspace</source>
        <translation>Enregistrer l’espace de travail</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>There is a workspace “%1” already.</source>
        <translation>Il y a déjà un espace de travail « %1 ».</translation>
    </message>
    <message>
        <source>It would be replaced by how the window is arranged now.</source>
        <translation>Il serait remplacé par la disposition actuelle de la fenêtre.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>The workspace “%1” was saved: View ▸ Workspaces.</source>
        <translation>L’espace de travail « %1 » est enregistré : Affichage ▸ Espaces de travail.</translation>
    </message>
    <message>
        <source>The workspace “%1” is damaged. Save it anew.</source>
        <translation>L’espace de travail « %1 » est endommagé. Enregistrez-le de nouveau.</translation>
    </message>
    <message>
        <source>&amp;Delete Workspace</source>
        <translation>&amp;Supprimer un espace de travail</translation>
    </message>
    <message>
        <source>Delete the workspace “%1”?</source>
        <translation>Supprimer l’espace de travail « %1 » ?</translation>
    </message>
    <message>
        <source>The window stays arranged as it is.</source>
        <translation>La fenêtre reste disposée telle quelle.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferencePanel</name>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Choose a picture to look at while painting</source>
        <translation>Choisir une image à regarder en peignant</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show all of the picture</source>
        <translation>Montrer toute l’image</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>A pixel of the picture is one of the screen</source>
        <translation>Un pixel de l’image est un pixel de l’écran</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Show no picture here; its file stays</source>
        <translation>Ne plus montrer d’image ici ; son fichier reste</translation>
    </message>
    <message>
        <source>Open Reference Picture</source>
        <translation>Ouvrir une image de référence</translation>
    </message>
    <message>
        <source>Actual pixels</source>
        <translation>Pixels réels</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferenceView</name>
    <message>
        <source>Reference picture</source>
        <translation>Image de référence</translation>
    </message>
    <message>
        <source>Arrow keys move a cross, and Return picks the colour there.</source>
        <translation>Les touches fléchées déplacent une croix, et Entrée y prélève la couleur.</translation>
    </message>
    <message>
        <source>Drop a picture here to look at it while you paint, and to take colours from it.</source>
        <translation>Déposez une image ici pour la regarder en peignant, et pour y prendre des couleurs.</translation>
    </message>
</context>
<context>
    <name>suffuse::ViewWindow</name>
    <message>
        <source>View of the painting</source>
        <translation>Vue du tableau</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>%1 · view at %2 %</source>
        <translation>%1 · vue à %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: install bubblewrap, and they have no network and can write nowhere else.</source>
        <translation>Les programmes sont limités en temps, en mémoire et en écriture, mais pas confinés : installez bubblewrap, et ils n’auront pas de réseau et ne pourront écrire nulle part ailleurs.</translation>
    </message>
    <message>
        <source>Programs are confined by bubblewrap: they have no network, unless they say that they need it, and can write in a temporary folder only.</source>
        <translation>Les programmes sont confinés par bubblewrap : ils n’ont pas de réseau, sauf s’ils disent en avoir besoin, et ne peuvent écrire que dans un dossier temporaire.</translation>
    </message>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: bubblewrap is installed, and does not work here (%1).</source>
        <translation>Les programmes sont limités en temps, en mémoire et en écriture, mais pas confinés : bubblewrap est installé, et ne fonctionne pas ici (%1).</translation>
    </message>
    <message>
        <source>it wrote no result</source>
        <translation>il n’a pas écrit de résultat</translation>
    </message>
    <message>
        <source>its result cannot be read</source>
        <translation>son résultat ne peut pas être lu</translation>
    </message>
    <message>
        <source>its result is no file</source>
        <translation>son résultat n’est pas un fichier</translation>
    </message>
    <message>
        <source>its result is too large</source>
        <translation>son résultat est trop grand</translation>
    </message>
    <message>
        <source>its result is empty</source>
        <translation>son résultat est vide</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected. Select strokes first.</source>
        <translation>Rien de visible et de déverrouillé n’est sélectionné. Sélectionnez d’abord des traits.</translation>
    </message>
    <message>
        <source>Nothing in the layer is visible and unlocked.</source>
        <translation>Rien dans le calque n’est visible et déverrouillé.</translation>
    </message>
    <message>
        <source>No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>Impossible de créer un dossier temporaire : %1. Donnez à TMPDIR un dossier accessible en écriture.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is the disk full?</source>
        <translation>%1 : écriture impossible (%2). Le disque est-il plein ?</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2.</source>
        <translation>Impossible de lancer le programme %1 : %2.</translation>
    </message>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>Il a été arrêté après %n seconde, le temps qui lui est accordé.</numerusform>
            <numerusform>Il a été arrêté après %n secondes, le temps qui lui est accordé.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was ended, since it took more than %1 MB of memory.</source>
        <translation>Il a été arrêté, car il prenait plus de %1 Mo de mémoire.</translation>
    </message>
    <message>
        <source>It was ended, since it wrote more than %1 MB.</source>
        <translation>Il a été arrêté, car il écrivait plus de %1 Mo.</translation>
    </message>
    <message>
        <source>The program was killed or crashed. The painting is as it was.</source>
        <translation>Le programme a été tué ou a planté. Le tableau est comme avant.</translation>
    </message>
    <message>
        <source>The program failed (exit code %1). The painting is as it was.</source>
        <translation>Le programme a échoué (code de sortie %1). Le tableau est comme avant.</translation>
    </message>
    <message>
        <source>It wrote: %1</source>
        <translation>Il a écrit : %1</translation>
    </message>
    <message>
        <source>Its result is not used, and the painting is as it was: %1.</source>
        <translation>Son résultat n’est pas utilisé, et le tableau est comme avant : %1.</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 n’a pas été écrit : %2.</translation>
    </message>
    <message>
        <source>a colour is red, yellow, blue and opacity, each from 0 to 1</source>
        <translation>une couleur est rouge, jaune, bleu et opacité, chacun de 0 à 1</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>indiquez un nombre</translation>
    </message>
    <message>
        <source>%1 is not in [%2, %3]</source>
        <translation>%1 n’est pas dans [%2, %3]</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>“%1” is none of %2</source>
        <translation>« %1 » ne figure pas parmi %2</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>indiquez true ou false</translation>
    </message>
    <message>
        <source>give a text of at most %1 characters</source>
        <translation>indiquez un texte d’au plus %1 caractères</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>choisissez un fichier</translation>
    </message>
    <message>
        <source>%1: the name must end with .%2</source>
        <translation>%1 : le nom doit se terminer par .%2</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1 : ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1 : ce dossier n’existe pas</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>« %1 » n’est pas un nombre</translation>
    </message>
    <message>
        <source>“%1” is neither true nor false</source>
        <translation>« %1 » n’est ni true ni false</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is larger than 1 MB</source>
        <translation>%1 : lecture impossible, ou plus de 1 Mo</translation>
    </message>
    <message>
        <source>%1: %2 has the id “%3”, too; give it another one</source>
        <translation>%1 : %2 a aussi l’identifiant « %3 » ; donnez-lui-en un autre</translation>
    </message>
    <message>
        <source>Python 3 is missing. Install python3.</source>
        <translation>Python 3 manque. Installez python3.</translation>
    </message>
    <message>
        <source>The program %1 is missing, or cannot be started. Install it.</source>
        <translation>Le programme %1 manque, ou ne peut pas être lancé. Installez-le.</translation>
    </message>
    <message>
        <source>%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and python3-numpy, or by pip as docs/python.md says.</source>
        <translation>%1 ne trouve pas les modules Python %2. Installez-les par des paquets comme python3-suffuse et python3-numpy, ou par pip comme l’indique docs/python.md.</translation>
    </message>
    <message>
        <source>name the program, and what it is started with</source>
        <translation>nommez le programme, et ce avec quoi il est lancé</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>“%1” is not “%2”</source>
        <translation>« %1 » n’est pas « %2 »</translation>
    </message>
    <message>
        <source>version %1 is not known; this program reads version %2</source>
        <translation>la version %1 n’est pas connue ; ce programme lit la version %2</translation>
    </message>
    <message>
        <source>“%1” does not look like %2</source>
        <translation>« %1 » n’a pas la forme de %2</translation>
    </message>
    <message>
        <source>a text has 1 to 2000 characters</source>
        <translation>un texte a de 1 à 2000 caractères</translation>
    </message>
    <message>
        <source>give a text, or one for each language</source>
        <translation>indiquez un texte, ou un par langue</translation>
    </message>
    <message>
        <source>give at most %1 texts of 1 to 4096 characters</source>
        <translation>indiquez au plus %1 textes de 1 à 4096 caractères</translation>
    </message>
    <message>
        <source>there are at most 3 submenus within each other</source>
        <translation>il y a au plus 3 niveaux de sous-menus</translation>
    </message>
    <message>
        <source>there are at most %1 fields</source>
        <translation>il y a au plus %1 champs</translation>
    </message>
    <message>
        <source>two fields are called %1</source>
        <translation>deux champs s’appellent %1</translation>
    </message>
    <message>
        <source>the field&apos;s type must stand before its default</source>
        <translation>le type du champ doit précéder sa valeur par défaut</translation>
    </message>
    <message>
        <source>there are at most %1 choices</source>
        <translation>il y a au plus %1 choix</translation>
    </message>
    <message>
        <source>is not above least</source>
        <translation>n’est pas supérieur à least</translation>
    </message>
    <message>
        <source>whole numbers are from -1000000000 to 1000000000</source>
        <translation>les nombres entiers vont de -1000000000 à 1000000000</translation>
    </message>
    <message>
        <source>“%1” is no ending; give it without its dot</source>
        <translation>« %1 » n’est pas une extension ; indiquez-la sans son point</translation>
    </message>
    <message>
        <source>a part of the painting was passed, so canvas, palette and underlay must stay as they are</source>
        <translation>une partie du tableau a été transmise, canevas, palette et modèle doivent donc rester tels quels</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>It went well.</source>
        <translation>Tout s’est bien passé.</translation>
    </message>
    <message>
        <source>The result does not fit into memory.</source>
        <translation>Le résultat ne tient pas en mémoire.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionDialog</name>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Exécuter</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 existe. Le remplacer ?</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Ce qu’il contient maintenant est perdu.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>It was stopped. The painting is as it was.</source>
        <translation>Arrêté. Le tableau est comme avant.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile, so the result is not used. Run it again.</source>
        <translation>Le tableau a changé entre-temps, le résultat n’est donc pas utilisé. Exécutez-la de nouveau.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionFields</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Choisir un dossier et un nom</translation>
    </message>
</context>
<context>
    <name>suffuse::ManageExtensionsDialog</name>
    <message>
        <source>Manage Extensions</source>
        <translation>Gérer les extensions</translation>
    </message>
    <message>
        <source>Extensions</source>
        <translation>Extensions</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Extension</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>About the extension</source>
        <translation>À propos de l’extension</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>&amp;Ouvrir le dossier</translation>
    </message>
    <message>
        <source>Your own extensions lie there, each in a folder with a manifest</source>
        <translation>Vos propres extensions s’y trouvent, chacune dans un dossier avec un manifeste</translation>
    </message>
    <message>
        <source>Read &amp;Again</source>
        <translation>&amp;Relire</translation>
    </message>
    <message>
        <source>Looks for extensions anew, after files were changed</source>
        <translation>Cherche de nouveau les extensions, après une modification de fichiers</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Vous</translation>
    </message>
    <message>
        <source>Suffuse</source>
        <translation>Suffuse</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>Inutilisable</translation>
    </message>
    <message>
        <source>There are no extensions yet. Put a folder with a manifest into yours.</source>
        <translation>Il n’y a pas encore d’extensions. Mettez un dossier avec un manifeste dans le vôtre.</translation>
    </message>
    <message>
        <source>It uses the network.</source>
        <translation>Elle utilise le réseau.</translation>
    </message>
    <message>
        <source>The last run: %1</source>
        <translation>La dernière exécution : %1</translation>
    </message>
    <message>
        <source>Your extensions lie in %1.</source>
        <translation>Vos extensions se trouvent dans %1.</translation>
    </message>
    <message>
        <source>What the chosen extension does, what is wrong with it, and what it wrote when it last ran</source>
        <translation>Ce que fait l’extension choisie, ce qui ne va pas avec elle, et ce qu’elle a écrit à sa dernière exécution</translation>
    </message>
    <message>
        <source>Those that are checked stand in the menu</source>
        <translation>Celles qui sont cochées figurent dans le menu</translation>
    </message>
</context>
<context>
    <name>ColourWords</name>
    <message>
        <source>dark red</source>
        <translation>rouge foncé</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rouge</translation>
    </message>
    <message>
        <source>light red</source>
        <translation>rouge clair</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>marron</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>light orange</source>
        <translation>orange clair</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>olive</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>jaune</translation>
    </message>
    <message>
        <source>light yellow</source>
        <translation>jaune clair</translation>
    </message>
    <message>
        <source>dark yellow-green</source>
        <translation>jaune-vert foncé</translation>
    </message>
    <message>
        <source>yellow-green</source>
        <translation>jaune-vert</translation>
    </message>
    <message>
        <source>light yellow-green</source>
        <translation>jaune-vert clair</translation>
    </message>
    <message>
        <source>dark green</source>
        <translation>vert foncé</translation>
    </message>
    <message>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <source>light green</source>
        <translation>vert clair</translation>
    </message>
    <message>
        <source>dark turquoise</source>
        <translation>turquoise foncé</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>turquoise</translation>
    </message>
    <message>
        <source>light turquoise</source>
        <translation>turquoise clair</translation>
    </message>
    <message>
        <source>dark blue</source>
        <translation>bleu foncé</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>bleu clair</translation>
    </message>
    <message>
        <source>dark violet</source>
        <translation>violet foncé</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>violet</translation>
    </message>
    <message>
        <source>light violet</source>
        <translation>violet clair</translation>
    </message>
    <message>
        <source>dark magenta</source>
        <translation>magenta foncé</translation>
    </message>
    <message>
        <source>magenta</source>
        <translation>magenta</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rose</translation>
    </message>
    <message>
        <source>black</source>
        <translation>noir</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>gris foncé</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>light grey</source>
        <translation>gris clair</translation>
    </message>
    <message>
        <source>white</source>
        <translation>blanc</translation>
    </message>
</context>
<context>
    <name>SpokenNames</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>More buttons</source>
        <translation>Autres boutons</translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message>
        <source>stroke %1</source>
        <translation>trait %1</translation>
    </message>
    <message>
        <source>even</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <source>feathered</source>
        <translation>à bords fondus</translation>
    </message>
    <message>
        <source>dark edge</source>
        <translation>à bord sombre</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>image</translation>
    </message>
    <message>
        <source>%1 and other colours</source>
        <translation>%1 et d’autres couleurs</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>rempli</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>masqué</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln trait</numerusform>
            <numerusform>%Ln traits</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>%Ln sélectionné</numerusform>
            <numerusform>%Ln sélectionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Selects this and nothing else</source>
        <translation>Sélectionne ceci et rien d’autre</translation>
    </message>
    <message>
        <source>Adds this to the selection, or takes it away</source>
        <translation>Ajoute ceci à la sélection, ou l’en retire</translation>
    </message>
</context>
<context>
    <name>suffuse::PenSpeech</name>
    <message>
        <source>Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.</source>
        <translation>Les touches fléchées déplacent le stylet, Espace l’abaisse et le relève. Échap le range.</translation>
    </message>
    <message>
        <source>The pen is put away.</source>
        <translation>Le stylet est rangé.</translation>
    </message>
    <message>
        <source>Pen down at %1.</source>
        <translation>Stylet abaissé à %1.</translation>
    </message>
    <message>
        <source>Pen up at %1.</source>
        <translation>Stylet relevé à %1.</translation>
    </message>
    <message>
        <source>Pen up at %1: %2.</source>
        <translation>Stylet relevé à %1 : %2.</translation>
    </message>
    <message>
        <source>Given up.</source>
        <translation>Abandonné.</translation>
    </message>
    <message>
        <source>Pressure %1 %</source>
        <translation>Pression %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>suffuse::Samples</name>
    <message>
        <source>Harbour</source>
        <translation>Le port</translation>
    </message>
    <message>
        <source>Ink Landscape</source>
        <translation>Paysage à l’encre</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <translation>Lanternes</translation>
    </message>
    <message>
        <source>Moonrise</source>
        <translation>Lever de lune</translation>
    </message>
    <message>
        <source>Sheet of Strokes</source>
        <translation>Planche de traits</translation>
    </message>
    <message>
        <source>Still Life</source>
        <translation>Nature morte</translation>
    </message>
</context>
</TS>
