<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>the principal point is far from the centre of the picture, which seems cut out of a larger one</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>le point principal est loin du centre de l’image, qui semble découpée dans une plus grande</translation>
  </message>
  <message>
   <source>with aspect ratio and principal point {px} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>avec rapport d’aspect et point principal {px} px : pas nettement mieux</translation>
  </message>
  <message>
   <source>coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>les coordonnées semblent être des pixels, attendues de 0 à 1 (x = {x:g}, y = {y:g})</translation>
  </message>
  <message>
   <source>without lens distortion the points are {without} px off, with it {with_it} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>sans distorsion les points sont à {without} px, avec elle à {with_it} px : pas nettement mieux</translation>
  </message>
  <message>
   <source>aspect ratio and principal point bring the points from {before} to {after} px, more than three parameters would by chance</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>rapport d’aspect et point principal amènent les points de {before} à {after} px, plus que trois paramètres par hasard</translation>
  </message>
  <message>
   <source>lens distortion brings the points from {before} to {after} px</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>la distorsion de l’objectif amène les points de {before} à {after} px</translation>
  </message>
  <message>
   <source>the points show lens distortion clearly and are {px} px off</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>les points montrent nettement une distorsion et sont à {px} px</translation>
  </message>
  <message>
   <source>even with the position known: {why}</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>même avec la position connue : {why}</translation>
  </message>
  <message>
   <source>{count} positions, and nothing tells which is its</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>{count} positions, et rien ne dit laquelle est la sienne</translation>
  </message>
  <message>
   <source>all labels fit with far and near exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>toutes les classes conviennent avec lointain et proche échangés</translation>
  </message>
  <message>
   <source>all labels fit with left and right exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>toutes les classes conviennent avec gauche et droite échangées</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, {before:.1f} px as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>les éléments sont en moyenne à {after:.1f} px, à {before:.1f} px tels quels</translation>
  </message>
  <message>
   <source>two points are exchanged: the one of {some} and the one of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>deux points sont échangés : celui de {some} et celui de {others}</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, no camera fits the labels as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>les éléments sont en moyenne à {after:.1f} px, aucune caméra ne convient aux classes telles quelles</translation>
  </message>
  <message>
   <source>{a} and {b} fit with each other's label</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} et {b} conviennent avec la classe l’un de l’autre</translation>
  </message>
  <message>
   <source>{titles} fit with each other's labels</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} conviennent avec les classes les uns des autres</translation>
  </message>
  <message>
   <source>relabel {steps}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>renommer : {steps}</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} est jusqu’à {px:.0f} px de là où la caméra des autres le montre</translation>
  </message>
  <message>
   <source>{title} is nowhere near where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} est loin de là où la caméra des autres le montre</translation>
  </message>
  <message>
   <source>without {titles} the others drop from {before:.1f} to {after:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>sans {titles} les autres passent de {before:.1f} à {after:.1f} px</translation>
  </message>
  <message>
   <source>swap {a} and {b}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>échanger {a} et {b}</translation>
  </message>
  <message>
   <source>{a} to {b}</source>
   <comment>labels</comment>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} en {b}</translation>
  </message>
  <message>
   <source>it lies where {title} should be</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>il est là où {title} devrait être</translation>
  </message>
  <message>
   <source>the others are {px:.1f} px off with and without it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>les autres sont à {px:.1f} px avec et sans lui</translation>
  </message>
  <message>
   <source>more than its own place is uncertain</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>plus que son propre lieu n’est incertain</translation>
  </message>
  <message>
   <source>relabel to {title}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>renommer en {title}</translation>
  </message>
  <message>
   <source>it lies on {title}, which is annotated as well</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>il est sur {title}, qui est annoté aussi</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera shows it; too few elements fit to say which are wrong</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} est jusqu’à {px:.0f} px de là où la caméra le montre ; trop peu d’éléments conviennent pour dire lesquels sont faux</translation>
  </message>
  <message>
   <source>no camera fits these labels together</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>aucune caméra ne convient à ces classes ensemble</translation>
  </message>
  <message>
   <source>exchange far and near in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>échanger lointain et proche sur toute l’image</translation>
  </message>
  <message>
   <source>exchange left and right in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>échanger gauche et droite sur toute l’image</translation>
  </message>
  <message>
   <source>turn the labels by half a turn</source>
   <extracomment>[procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>tourner les classes d’un demi-tour</translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn</source>
   <extracomment>the camera stands on a side of the field where hardly any other of {n} frame does: a camera of its own, or labels turned by half a turn / the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>la caméra est d’un côté du terrain où presque aucune autre de {n} image n’est : une caméra à part, ou des classes tournées d’un demi-tour</numerusform>
    <numerusform>la caméra est d’un côté du terrain où presque aucune autre de {n} images n’est : une caméra à part, ou des classes tournées d’un demi-tour</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does</source>
   <extracomment>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frame does / the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>la caméra est de l’autre côté du terrain que les autres ; avec ses classes tournées d’un demi-tour elle est là où est celle de {n} image</numerusform>
    <numerusform>la caméra est de l’autre côté du terrain que les autres ; avec ses classes tournées d’un demi-tour elle est là où est celle de {n} images</numerusform>
   </translation>
  </message>
  <message>
   <source>no such class: {name!r}, did you mean {title}?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>pas de telle classe : {name!r}, vouliez-vous dire {title} ?</translation>
  </message>
  <message>
   <source>{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more than any lens bends it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} est droit sur le terrain, ses points s’écartent jusqu’à {px:.0f} px d’une droite, plus qu’aucun objectif ne la courbe</translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points, a line takes two</source>
   <extracomment>{title} has {n} point, a line takes two / {title} has {n} points, a line takes two [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} a {n} point, il en faut deux pour une ligne</numerusform>
    <numerusform>{title} a {n} points, il en faut deux pour une ligne</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points; a curve takes at least {least}</source>
   <extracomment>{title} has {n} point; a curve takes at least {least} / {title} has {n} points; a curve takes at least {least} [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} a {n} point ; une courbe en demande au moins {least}</numerusform>
    <numerusform>{title} a {n} points ; une courbe en demande au moins {least}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points: {least} points needed for a curve</source>
   <extracomment>{title} has {n} point: {least} points needed for a curve / {title} has {n} points: {least} points needed for a curve [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} a {n} point : une courbe en demande {least}</numerusform>
    <numerusform>{title} a {n} points : une courbe en demande {least}</numerusform>
   </translation>
  </message>
  <message>
   <source>{title} is a single place, it has {count} points up to {px:.0f} px apart</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} est un seul lieu, il a {count} points éloignés jusqu’à {px:.0f} px</translation>
  </message>
  <message>
   <source>the points of {title} go back and forth instead of along it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>les points de {title} vont et viennent au lieu de le suivre</translation>
  </message>
  <message>
   <source>no such class: {name!r} fits no camera, and counts as missed where it is scored</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>pas de telle classe : {name!r} ne convient à aucune caméra, et compte comme manquée là où l’on note</translation>
  </message>
  <message>
   <source>{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two names?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{a} et {b} sont l’un sur l’autre, à moins de {px:.0f} px : une ligne sous deux noms ?</translation>
  </message>
  <message>
   <source>remove point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>retirer le point {number}</translation>
  </message>
  <message>
   <source>look at point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>aller voir le point {number}</translation>
  </message>
  <message>
   <source>the points of {title} go over the same stretch more than once: their course is {times:.1f} times as long as it need be</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>les points de {title} passent plusieurs fois sur le même tronçon : leur parcours est {times:.1f} fois plus long qu’il ne faut</translation>
  </message>
  <message>
   <source>That is annotated already</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>C’est déjà annoté</translation>
  </message>
  <message>
   <source>its corner</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>son coin</translation>
  </message>
  <message>
   <source>the picture's edge</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>le bord de l’image</translation>
  </message>
  <message>
   <source>move its points onto the line</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>mettre ses points sur la ligne</translation>
  </message>
  <message>
   <source>{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} est courbe : entre les points, sa ligne s’écarte jusqu’à {px:.0f} px. Appuyez sur R pour la suivre</translation>
  </message>
  <message>
   <source>one end of {title} is {px:.0f} px off the line. Move it onto the paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>un bout de {title} est à {px:.0f} px de la ligne. Mettez-le sur la peinture</translation>
  </message>
  <message>
   <source>{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends? Press R</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{percent:.0f} % de {title} n’est pas sur la peinture (plus long vide : {px:.0f} px). Ligne courbe ? Appuyez sur R</translation>
  </message>
  <message>
   <source>one end of {title} is not on paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>un bout de {title} n’est pas sur la peinture</translation>
  </message>
  <message>
   <source>{title} stops {px:.0f} px short of {what}</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>à {title} il manque {px:.0f} px pour atteindre {what}</translation>
  </message>
  <message>
   <source>look at it</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>aller voir</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>le point {number} de {title} est à {off:.0f} px, ses autres points au plus à {rest:.1f} px</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>le point {number} de {title} est à {off:.0f} px, son autre point au plus à {rest:.1f} px</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>tout est à l’envers : lointain et proche sont échangés</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>tout est à l’envers : gauche et droite sont échangées</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, or left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>tout est à l’envers : lointain et proche, ou gauche et droite, sont échangés</translation>
  </message>
  <message>
   <source>{title} is on the wrong side of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{title} est du mauvais côté de {others}</translation>
  </message>
  <message>
   <source>{titles} lie on each other's side of the elements around them</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} sont chacun du côté de l’autre par rapport aux éléments alentour</translation>
  </message>
  <message>
   <source>{titles} cannot lie this way round to each other, whatever the camera</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} ne peuvent être ainsi l’un par rapport à l’autre, quelle que soit la caméra</translation>
  </message>
  <message>
   <source>only {share:.0%} of the lines in sight are on paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py, procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>seulement {share:.0%} des lignes en vue sont sur de la peinture</translation>
  </message>
  <message>
   <source>there is too little paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>il y a trop peu de peinture</translation>
  </message>
  <message>
   <source>the paint nearby would take a peg from its place</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>la peinture voisine ôterait un piquet de sa place</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line, and {more} more are off theirs</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} est à {px:.0f} px de sa ligne, et {more} autres de la leur</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} est à {px:.0f} px de sa ligne</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, {needed} needed</source>
   <extracomment>{n} element, {needed} needed / {n} elements, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} élément, il en faut {needed}</numerusform>
    <numerusform>{n} éléments, il en faut {needed}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{points} points on {n} elements, two different ones on each of {needed} needed</source>
   <extracomment>{points} points on {n} element, two different ones on each of {needed} needed / {points} points on {n} elements, two different ones on each of {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{points} points sur {n} élément, il en faut deux différents sur chacun de {needed}</numerusform>
    <numerusform>{points} points sur {n} éléments, il en faut deux différents sur chacun de {needed}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} elements on the ground, {needed} needed</source>
   <extracomment>{n} element on the ground, {needed} needed / {n} elements on the ground, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} élément au sol, il en faut {needed}</numerusform>
    <numerusform>{n} éléments au sol, il en faut {needed}</numerusform>
   </translation>
  </message>
  <message>
   <source>all points lie in one place of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>tous les points sont au même endroit de l’image</translation>
  </message>
  <message>
   <source>all points lie on one line of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>tous les points sont sur une même ligne de l’image</translation>
  </message>
  <message>
   <source>not a plausible pose: the fit did not settle</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : l’ajustement ne s’est pas stabilisé</translation>
  </message>
  <message>
   <source>not a plausible pose: on the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : au sol</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.1f} m below the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : {metres:.1f} m sous le sol</translation>
  </message>
  <message>
   <source>not a plausible pose: only {metres:.1f} m above the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : seulement {metres:.1f} m au-dessus du sol</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.0f} m from the field's centre</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : à {metres:.0f} m du centre du terrain</translation>
  </message>
  <message>
   <source>not a plausible pose: rolled by {degrees:.0f} degrees</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : roulis de {degrees:.0f} degrés</translation>
  </message>
  <message>
   <source>not a plausible pose: focal length {px:.0f} px at 960 px width</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose peu plausible : focale de {px:.0f} px pour 960 px de large</translation>
  </message>
  <message>
   <source>pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>panoramique, inclinaison ou roulis ± plus de {degrees:g}°, position ± plus de {way:g} % du chemin vers le centre du terrain, ou focale ± plus de {focal:g} %, ou des clics identiques vus de l’autre bout</translation>
  </message>
  <message>
   <source>no camera explains these elements together: the best one misses half of them by more than {px:.0f} px (are the labels right?)</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>aucune caméra n’explique ces éléments ensemble : la meilleure en manque la moitié de plus de {px:.0f} px (les classes sont-elles justes ?)</translation>
  </message>
  <message>
   <source>pan ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>panoramique ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>tilt ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>inclinaison ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>roll ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>roulis ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>position ± {metres:.0f} m</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>position ± {metres:.0f} m</translation>
  </message>
  <message>
   <source>focal length ± {percent:.0f} %</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>focale ± {percent:.0f} %</translation>
  </message>
  <message>
   <source>the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>identique vue de l’autre bout</translation>
  </message>
  <message>
   <source>a different view fits almost as well</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>une autre vue convient presque aussi bien</translation>
  </message>
  <message>
   <source>expected lines are missing</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>des lignes attendues manquent</translation>
  </message>
  <message>
   <source>some lines in the picture do not match the field</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>certaines lignes de l’image ne correspondent pas au terrain</translation>
  </message>
  <message>
   <source>too few lines in view</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>trop peu de lignes en vue</translation>
  </message>
  <message>
   <source>unusual camera position</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>position de caméra inhabituelle</translation>
  </message>
  <message>
   <source>the visible lines do not determine the camera</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>les lignes visibles ne déterminent pas la caméra</translation>
  </message>
  <message>
   <source>{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{lines:.0f} % des lignes attendues trouvées, {paint:.0f} % de la peinture visible expliquée</translation>
  </message>
  <message>
   <source>is this {field}? {why}</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>est-ce bien {field} ? {why}</translation>
  </message>
  <message>
   <source>no camera fits the lines (best: {shares})</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>aucune caméra ne convient aux lignes (la meilleure : {shares})</translation>
  </message>
  <message>
   <source>the picture is nearly square: its pixels may not be</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>l’image est presque carrée : ses pixels ne le sont peut-être pas</translation>
  </message>
  <message>
   <source>{field} has no painted lines to look for</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{field} n’a pas de lignes peintes à rechercher</translation>
  </message>
  <message>
   <source>no camera has its lines on the paint of this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>aucune caméra n’a ses lignes sur la peinture de cette image</translation>
  </message>
  <message>
   <source>there is hardly any paint on the ground in this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>il n’y a presque pas de peinture au sol dans cette image</translation>
  </message>
  <message>
   <source>too little paint in sight</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>trop peu de peinture en vue</translation>
  </message>
  <message>
   <source>too little of what should be in sight was found</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>trop peu de ce qui devrait se voir a été trouvé</translation>
  </message>
  <message>
   <source>the paint that was found would move the camera too far</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>la peinture trouvée déplacerait trop la caméra</translation>
  </message>
  <message>
   <source>the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>les pixels ne sont peut-être pas {aspect:.3f} fois plus larges que hauts ({percent:.0f} %)</translation>
  </message>
  <message>
   <source>the track is {px:.0f} px off the nearest frame whose camera was known</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>le suivi s’écarte de {px:.0f} px de l’image la plus proche dont la caméra était connue</translation>
  </message>
  <message>
   <source>{count} of {total} clicks lie where the camera shows nothing</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>{count} clics sur {total} sont là où la caméra ne montre rien</translation>
  </message>
  <message>
   <source>the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least {least:g} are needed)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>les vues le regardent presque de la même direction ({degrees:.2f} degrés d’écart, il en faut au moins {least:g})</translation>
  </message>
  <message>
   <source>clicked in no view that has a camera</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>cliqué dans aucune vue qui ait une caméra</translation>
  </message>
  <message>
   <source>cameras that know only the ground (homographies) have no position in space</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>les caméras qui ne connaissent que le sol (homographies) ne donnent aucun lieu dans l’espace</translation>
  </message>
  <message>
   <source>the lines of sight meet behind the camera of {names}</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>les lignes de visée se croisent derrière la caméra de {names}</translation>
  </message>
  <message>
   <source>clicked in one view only</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>cliqué dans une seule vue</translation>
  </message>
  <message>
   <source>would be farther than {metres:g} m from the field</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>serait à plus de {metres:g} m du terrain</translation>
  </message>
  <message>
   <source>the views do not agree: {far} px off (is it the same place in all of them, and are the cameras right?)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>les vues ne s’accordent pas : {far} px (est-ce le même lieu dans toutes, et les caméras sont-elles justes ?)</translation>
  </message>
  <message>
   <source>Fitted to the clicks of each frame; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>Ajustée aux clics de chaque image ; rien n’en est dans un fichier</translation>
  </message>
  <message>
   <source>the paint is {px:.1f} px from the lines</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>la peinture est à {px:.1f} px des lignes</translation>
  </message>
  <message>
   <source>Followed through the shot; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>Suivie à travers le plan ; rien n’en est dans un fichier</translation>
  </message>
  <message>
   <source>no track here: {why}</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>pas de suivi ici : {why}</translation>
  </message>
  <message>
   <source>no fit of {frame} yet</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>pas encore d’ajustement de {frame}</translation>
  </message>
  <message>
   <source>no camera was found</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py, procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>aucune caméra n’a été trouvée</translation>
  </message>
  <message>
   <source>carried over by the picture's motion, not measured on paint</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>prolongée par le mouvement de l’image, non mesurée sur la peinture</translation>
  </message>
  <message>
   <source>not followed so far</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>pas suivie jusqu’ici</translation>
  </message>
  <message>
   <source>{title} was surveyed: its position stays as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} a été mesuré sur place : sa position reste ce qu’elle est</translation>
  </message>
  <message>
   <source>{title} moves: its positions hold for an instant each</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} se déplace : chacune de ses positions vaut pour un instant</translation>
  </message>
  <message>
   <source>its camera is hardly determined: {what}</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>sa caméra est à peine déterminée : {what}</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why}), and {count} more</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>pas de caméra dans {frame} ({why}), et {count} de plus</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why})</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>pas de caméra dans {frame} ({why})</translation>
  </message>
  <message>
   <source>surveyed: kept as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>mesuré sur place : reste ce qu’il est</translation>
  </message>
  <message>
   <source>untouched</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>intacte</translation>
  </message>
  <message>
   <source>in progress</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>en cours</translation>
  </message>
  <message>
   <source>done</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>terminée</translation>
  </message>
  <message>
   <source>approved</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>approuvée</translation>
  </message>
  <message>
   <source>rejected</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>rejetée</translation>
  </message>
  <message>
   <source>clicked</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>cliqués</translation>
  </message>
  <message>
   <source>snapped</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>aimantés</translation>
  </message>
  <message>
   <source>regularised</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>régularisés</translation>
  </message>
  <message>
   <source>copied</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>copiés</translation>
  </message>
  <message>
   <source>moved</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>déplacés</translation>
  </message>
  <message>
   <source>accepted suggestion</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>suggestions acceptées</translation>
  </message>
  <message>
   <source>proposed</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>proposés</translation>
  </message>
  <message>
   <source>accepted proposal</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>propositions acceptées</translation>
  </message>
  <message>
   <source>unconfirmed by paint</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>non confirmés par la peinture</translation>
  </message>
  <message>
   <source>from the file</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>du fichier</translation>
  </message>
  <message>
   <source>camera</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>caméra</translation>
  </message>
  <message>
   <source>annotation</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>annotation</translation>
  </message>
  <message>
   <source>fine</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>correct</translation>
  </message>
  <message>
   <source>camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>caméra fausse</translation>
  </message>
  <message>
   <source>labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>annotation fausse</translation>
  </message>
  <message>
   <source>OK</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>annulé</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>enregistré</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/dataset/workspace.py]</extracomment>
   <translation>comme trouvé</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>ce qui a été enregistré ailleurs</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>écrasé</translation>
  </message>
  <message>
   <source>fitted on these clicks</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustée à ces clics</translation>
  </message>
  <message>
   <source>fitted to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustée à une autre version de ces annotations</translation>
  </message>
  <message>
   <source>fitted on these clicks, or to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustée à ces clics, ou à une autre version de ces annotations</translation>
  </message>
  <message>
   <source>closer to these clicks than a prediction can be</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>plus proche de ces clics que ne peut l'être une prédiction</translation>
  </message>
  <message>
   <source>by file type and content</source>
   <extracomment>[procc_annotator/formats/cameras/registry.py]</extracomment>
   <translation>selon le type et le contenu du fichier</translation>
  </message>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Fichier</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Édition</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Image</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Élément</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, the menus]</extracomment>
   <translation>Affichage</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/command_palette.py, the menus]</extracomment>
   <translation>Caméra</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Aide</translation>
  </message>
  <message>
   <source>The picture cannot be shown</source>
   <extracomment>[procc_annotator/gui/canvas/annotation_preview.py]</extracomment>
   <translation>L’image ne peut être montrée</translation>
  </message>
  <message>
   <source>no camera is known here that could be dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>aucune caméra à faire glisser n’est connue ici</translation>
  </message>
  <message>
   <source>taken back: the camera is as before it was dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>annulé : la caméra est comme avant le glissement</translation>
  </message>
  <message>
   <source>overlays are hidden (Ctrl+H)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>les superpositions sont cachées (Ctrl+H)</translation>
  </message>
  <message>
   <source>a homography cannot be turned: choose another model (panel Fit)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>une homographie ne peut être tournée : choisissez un autre modèle (panneau Ajustement)</translation>
  </message>
  <message>
   <source>release leaves it here</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>relâcher la laisse ici</translation>
  </message>
  <message>
   <source>Esc puts it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py, procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap la remet en place</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs hold the camera</source>
   <extracomment>{n} peg holds the camera / {n} pegs hold the camera [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>{n} piquet tient la caméra</numerusform>
    <numerusform>{n} piquets tiennent la caméra</numerusform>
   </translation>
  </message>
  <message>
   <source>CAMERA</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>CAMÉRA</translation>
  </message>
  <message numerus="yes">
   <source>peg taken away: {n} pegs left</source>
   <extracomment>peg taken away: {n} peg left / peg taken away: {n} pegs left [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>piquet retiré : il reste {n} piquet</numerusform>
    <numerusform>piquet retiré : il reste {n} piquets</numerusform>
   </translation>
  </message>
  <message>
   <source>peg taken away: the camera is as it was found</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>piquet retiré : la caméra est comme elle a été trouvée</translation>
  </message>
  <message>
   <source>peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>piquet</translation>
  </message>
  <message>
   <source>press on a line of the wireframe</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>pressez sur une ligne du fil de fer</translation>
  </message>
  <message>
   <source>drag moves this peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>glisser déplace ce piquet</translation>
  </message>
  <message>
   <source>click takes it away</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>un clic le retire</translation>
  </message>
  <message>
   <source>drag a place of the wireframe to where it belongs</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>glissez un endroit du fil de fer à sa place</translation>
  </message>
  <message>
   <source>drag {title} to where it belongs: the camera follows</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>glissez {title} à sa place : la caméra suit</translation>
  </message>
  <message>
   <source>Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Ctrl+Z l’annule</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py, procc_annotator/gui/settings.py, procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Image</translation>
  </message>
  <message>
   <source>PAN</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>DÉPLACER</translation>
  </message>
  <message>
   <source>drag moves the picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>glisser déplace l’image</translation>
  </message>
  <message>
   <source>Esc takes the tool again</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Échap reprend l’outil</translation>
  </message>
  <message>
   <source>load a second set of cameras to blink between two (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>chargez un second jeu de caméras pour alterner entre deux (Ctrl+L)</translation>
  </message>
  <message>
   <source>crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks, Esc puts it away</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>réticule : les flèches le déplacent (Maj 0.1 px, Ctrl 10 px, Ctrl+Maj 100 px), Espace clique, Échap le range</translation>
  </message>
  <message>
   <source>point at a line first: with the mouse, or with the arrows</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>pointez d’abord une ligne : avec la souris ou avec les flèches</translation>
  </message>
  <message>
   <source>there is no line here to put a point on</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>il n’y a pas de ligne ici où mettre un point</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>caméra illisible</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>pas de caméra ici</translation>
  </message>
  <message>
   <source>next: {title}</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>suivant : {title}</translation>
  </message>
  <message>
   <source>{title}  ±{sd:.1f} px  unsure</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>{title}  ±{sd:.1f} px  incertain</translation>
  </message>
  <message>
   <source>{title} has no points in this frame: choose the element to delete</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} n’a pas de points sur cette image : choisissez l’élément à supprimer</translation>
  </message>
  <message>
   <source>choose the element to delete first: field map, list, or its key</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>choisissez d’abord l’élément à supprimer : plan du terrain, liste ou touche</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} points of {title}</source>
   <extracomment>dropped {n} point of {title} / dropped {n} points of {title} [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{n} point de {title} abandonné</numerusform>
    <numerusform>{n} points de {title} abandonnés</numerusform>
   </translation>
  </message>
  <message>
   <source>{titles}: changed elsewhere, look again first</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{titles} : changé ailleurs, regardez d’abord</translation>
  </message>
  <message numerus="yes">
   <source>kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on</source>
   <extracomment>kept {n} click of {title} on {frame}, unfinished: choose it there to go on / kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{n} clic de {title} sur {frame} est conservé, inachevé : choisissez-le là pour continuer</numerusform>
    <numerusform>{n} clics de {title} sur {frame} sont conservés, inachevés : choisissez-le là pour continuer</numerusform>
   </translation>
  </message>
  <message>
   <source>finished {title}</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} terminé</translation>
  </message>
  <message>
   <source>How good the fitted camera is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Ce que vaut la caméra ajustée</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>mètres au sol, 1 σ</translation>
  </message>
  <message>
   <source>How good the fitted camera ({model}) is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Ce que vaut la caméra ajustée ({model})</translation>
  </message>
  <message>
   <source>{metres:g} m, asked of offside technology</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m, exigés de la technologie du hors-jeu</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd, median {median:.2f}</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>mètres au sol, 1 σ, médiane {median:.2f}</translation>
  </message>
  <message>
   <source>metres on the ground</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>mètres au sol</translation>
  </message>
  <message>
   <source>{metres:g} m: {percent:.0f} % of the field in sight</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m : {percent:.0f} % du terrain en vue</translation>
  </message>
  <message>
   <source>Blind: no camera is shown before Ctrl+Enter</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Aveugle : aucune caméra n’est montrée avant Ctrl+Entrée</translation>
  </message>
  <message>
   <source>Blind mode, this frame is committed</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Mode aveugle, cette image est remise</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs</source>
   <extracomment>{n} peg / {n} pegs [procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>
    <numerusform>{n} piquet</numerusform>
    <numerusform>{n} piquets</numerusform>
   </translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra glissée, {pegs}, précisée sur la peinture : {share:.0%} de ses lignes</translation>
  </message>
  <message>
   <source>Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra trouvée, incertaine : {why}. Maj+Entrée l’accepte, Suppr la rejette</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, not made exact: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra glissée, {pegs}, non précisée : {why}</translation>
  </message>
  <message>
   <source>Drag to move the divider (arrow keys do it too)</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Glisser déplace la séparation (les flèches aussi)</translation>
  </message>
  <message>
   <source>Divider of the split view</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Séparation de la vue partagée</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra glissée, {pegs}</translation>
  </message>
  <message>
   <source>Camera of the track: Shift+Enter accepts its elements</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra du suivi : Maj+Entrée accepte ses éléments</translation>
  </message>
  <message>
   <source>Looking for the camera in the picture …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Recherche de la caméra dans l’image …</translation>
  </message>
  <message>
   <source>No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport? Click here</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Aucune caméra trouvée : {why}. Pour commencer, {advice} (Entrée prend le premier). Un autre sport ? Cliquez ici</translation>
  </message>
  <message>
   <source>Camera found, sure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra trouvée, sûre : {why}</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}: its lines are looked for …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra glissée, {pegs} : ses lignes sont recherchées …</translation>
  </message>
  <message>
   <source>Camera of the track, unsure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Caméra du suivi, incertaine : {why}</translation>
  </message>
  <message>
   <source>nothing changed: regular already, or no painted line was found there</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>rien n’a changé : déjà régulier, ou aucune ligne peinte n’y a été trouvée</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, along the track; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copié de {frame}, le long du suivi ; Maj+V confirme tout</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, moved with the camera; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copié de {frame}, déplacé avec la caméra ; Maj+V confirme tout</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, as they were: no motion found; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copié de {frame}, tel quel : aucun mouvement trouvé ; Maj+V confirme tout</translation>
  </message>
  <message>
   <source>taken back: nothing is regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>annulé : rien n’est régularisé</translation>
  </message>
  <message>
   <source>taken back: nothing is copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>annulé : rien n’est copié</translation>
  </message>
  <message>
   <source>the frame was left: nothing was regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>l’image a été quittée : rien n’a été régularisé</translation>
  </message>
  <message>
   <source>the frame was left: nothing was copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>l’image a été quittée : rien n’a été copié</translation>
  </message>
  <message numerus="yes">
   <source>{n} points unconfirmed by paint</source>
   <extracomment>{n} point unconfirmed by paint / {n} points unconfirmed by paint [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{n} point non confirmé par la peinture</numerusform>
    <numerusform>{n} points non confirmés par la peinture</numerusform>
   </translation>
  </message>
  <message>
   <source>regularise {what}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>régulariser {what}</translation>
  </message>
  <message>
   <source>copy from {frame}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>copier de {frame}</translation>
  </message>
  <message>
   <source>left out, not in the picture or no line seen: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>omis, hors de l’image ou aucune ligne visible : {elements}</translation>
  </message>
  <message>
   <source>choose an annotated element first</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>choisissez d’abord un élément annoté</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements</source>
   <extracomment>{n} element / {n} elements [procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>
    <numerusform>{n} élément</numerusform>
    <numerusform>{n} éléments</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>regularised {what}: {n} points</source>
   <extracomment>regularised {what}: {n} point / regularised {what}: {n} points [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{what} régularisé : {n} point</numerusform>
    <numerusform>{what} régularisé : {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} has corners or is one place: it stays as it is</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{element} a des coins ou n’est qu’un seul lieu : il reste tel quel</translation>
  </message>
  <message>
   <source>no element of the field is annotated here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>aucun élément du terrain n’est annoté ici</translation>
  </message>
  <message>
   <source>no frame before this one is annotated</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>aucune image avant celle-ci n’est annotée</translation>
  </message>
  <message>
   <source>{frame} has no element that is missing here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} n’a aucun élément qui manque ici</translation>
  </message>
  <message>
   <source>{element} becomes {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} devient {other}</translation>
  </message>
  <message>
   <source>duplicate {element} as {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>dupliquer {element} en {other}</translation>
  </message>
  <message>
   <source>merge {element} into {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>fusionner {element} dans {other}</translation>
  </message>
  <message>
   <source>close gaps</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>fermer les écarts</translation>
  </message>
  <message numerus="yes">
   <source>confirm {n} elements</source>
   <extracomment>confirm {n} element / confirm {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>confirmer {n} élément</numerusform>
    <numerusform>confirmer {n} éléments</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>drop {n} unconfirmed elements</source>
   <extracomment>drop {n} unconfirmed element / drop {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>écarter {n} élément non confirmé</numerusform>
    <numerusform>écarter {n} éléments non confirmés</numerusform>
   </translation>
  </message>
  <message>
   <source>Name of the line</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Nom de la ligne</translation>
  </message>
  <message>
   <source>What is this line?</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Quelle est cette ligne ?</translation>
  </message>
  <message>
   <source>{element} is a curve, which two points do not show: click on</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} est une courbe, que deux points ne montrent pas : continuer à cliquer</translation>
  </message>
  <message>
   <source>swap {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>échanger {element} et {other}</translation>
  </message>
  <message>
   <source>{element} is its own symmetric element</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} est sa propre classe symétrique</translation>
  </message>
  <message numerus="yes">
   <source>{elements} are annotated already</source>
   <extracomment>{elements} is annotated already / {elements} are annotated already [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{elements} est déjà annoté</numerusform>
    <numerusform>{elements} sont déjà annotés</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} lies where {other} is: drag it to its place</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} est là où est {other} : glissez-le à sa place</translation>
  </message>
  <message>
   <source>reverse {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>inverser {element}</translation>
  </message>
  <message>
   <source>choose the point to split at first (edit mode)</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>choisissez d’abord le point où couper (mode édition)</translation>
  </message>
  <message>
   <source>split {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>couper {element}</translation>
  </message>
  <message numerus="yes">
   <source>confirmed {n} elements</source>
   <extracomment>confirmed {n} element / confirmed {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} élément confirmé</numerusform>
    <numerusform>{n} éléments confirmés</numerusform>
   </translation>
  </message>
  <message>
   <source>nothing is unconfirmed on this frame</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>rien n’est à confirmer sur cette image</translation>
  </message>
  <message>
   <source>{element} is annotated already</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} est déjà annoté</translation>
  </message>
  <message>
   <source>no end is that near to a corner or the picture's edge</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>aucun bout n’est si près d’un coin ou du bord de l’image</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} unconfirmed elements</source>
   <extracomment>dropped {n} unconfirmed element / dropped {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} élément non confirmé écarté</numerusform>
    <numerusform>{n} éléments non confirmés écartés</numerusform>
   </translation>
  </message>
  <message>
   <source>Another element…</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Autre élément…</translation>
  </message>
  <message>
   <source>Leave it unnamed</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>La laisser sans nom</translation>
  </message>
  <message>
   <source>an element is split at a point between its ends, into a class that is free</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>un élément se coupe à un point entre ses bouts, vers une classe libre</translation>
  </message>
  <message>
   <source>{element} was changed elsewhere: look at it again</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} a été changé ailleurs : regardez-le à nouveau</translation>
  </message>
  <message>
   <source>? (stays as it is, an unknown class)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>? (reste telle quelle, une classe inconnue)</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Laisser de côté</translation>
  </message>
  <message>
   <source>Label</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Étiquette</translation>
  </message>
  <message>
   <source>Shapes</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Formes</translation>
  </message>
  <message>
   <source>Stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Signifie</translation>
  </message>
  <message>
   <source>Why</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Pourquoi</translation>
  </message>
  <message>
   <source>sure</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>sûr</translation>
  </message>
  <message>
   <source>likely</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>probable</translation>
  </message>
  <message>
   <source>to be said</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>à dire</translation>
  </message>
  <message numerus="yes">
   <source>{n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on.</source>
   <extracomment>{n} label is no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. / {n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. [procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>
    <numerusform>{n} étiquette n’est pas une classe de {field}. Dites ce qu’elle signifie ; la proposition vient de ses mots et des éléments sur lesquels sont ses formes.</numerusform>
    <numerusform>{n} étiquettes ne sont pas des classes de {field}. Dites ce qu’elles signifient ; les propositions viennent de leurs mots et des éléments sur lesquels sont leurs formes.</numerusform>
   </translation>
  </message>
  <message>
   <source>These names are more like those of {field}: choose that field first (File &gt; Field).</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ces noms ressemblent plus à ceux de {field} : choisissez d’abord ce terrain (Fichier &gt; Terrain).</translation>
  </message>
  <message>
   <source>Names of another program</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Noms d’un autre programme</translation>
  </message>
  <message>
   <source>Keep these names with the dataset ({file})</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Garder ces noms avec le jeu de données ({file})</translation>
  </message>
  <message>
   <source>Import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importer</translation>
  </message>
  <message>
   <source>What {label} stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ce que signifie {label}</translation>
  </message>
  <message>
   <source>What came of it</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ce qui en est sorti</translation>
  </message>
  <message>
   <source>Import annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importer des annotations</translation>
  </message>
  <message>
   <source>Annotations to import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotations à importer</translation>
  </message>
  <message>
   <source>Look into the files</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Regarder dans les fichiers</translation>
  </message>
  <message>
   <source>Only frames without annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Seulement les images où rien n’est encore annoté</translation>
  </message>
  <message>
   <source>Replace what is annotated in the others, too</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Remplacer aussi ce qui est annoté dans les autres</translation>
  </message>
  <message>
   <source>What was there stays among the earlier versions of its frame, and undo brings it back</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ce qui y était reste parmi les versions antérieures de l’image, et annuler le ramène</translation>
  </message>
  <message>
   <source>Annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotations</translation>
  </message>
  <message>
   <source>Format</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Format</translation>
  </message>
  <message>
   <source>Import into</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importer dans</translation>
  </message>
  <message>
   <source>Annotations (*.json *.xml *.zip);;All files (*)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotations (*.json *.xml *.zip);;Tous les fichiers (*)</translation>
  </message>
  <message>
   <source>Export as</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Exporter sous</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Exporter…</translation>
  </message>
  <message>
   <source>One zip archive instead of a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Une archive zip au lieu d’un dossier</translation>
  </message>
  <message>
   <source>Replace files that are there</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Remplacer les fichiers existants</translation>
  </message>
  <message>
   <source>Keep elements that SoccerNet has no class for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Garder les éléments pour lesquels SoccerNet n’a pas de classe</translation>
  </message>
  <message>
   <source>Width of the lines</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Largeur des lignes</translation>
  </message>
  <message>
   <source>Copy the pictures as well</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Copier aussi les images</translation>
  </message>
  <message>
   <source>Export to a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Exporter dans un dossier</translation>
  </message>
  <message>
   <source>Keeps {holds}.
Loses {loses}.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Garde {holds}.
Perd {loses}.</translation>
  </message>
  <message>
   <source>Add these names to the dataset's {file}, written anew</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ajouter ces noms à {file} du jeu, réécrit</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/messages.py]</extracomment>
   <translation>Abandonner</translation>
  </message>
  <message>
   <source>Close</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Fermer</translation>
  </message>
  <message>
   <source>A folder, a zip archive, or one file</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Un dossier, une archive zip ou un seul fichier</translation>
  </message>
  <message>
   <source>File…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Fichier…</translation>
  </message>
  <message>
   <source>Folder…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Dossier…</translation>
  </message>
  <message>
   <source>Frames are matched by the name of their picture.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Les images sont appariées par le nom de leur fichier.</translation>
  </message>
  <message>
   <source>Zip archive (*.zip)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Archive zip (*.zip)</translation>
  </message>
  <message>
   <source>{frames}, {elements} and {points} written to {path} ({format}).</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frames}, {elements} et {points} écrits dans {path} ({format}).</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} annotations</source>
   <extracomment>{n:,} annotation / {n:,} annotations [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} annotation</numerusform>
    <numerusform>{n:,} annotations</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>JaC of {n:,} frames</source>
   <extracomment>JaC of {n:,} frame / JaC of {n:,} frames [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>JaC de {n:,} image</numerusform>
    <numerusform>JaC de {n:,} images</numerusform>
   </translation>
  </message>
  <message>
   <source>Not everything could be saved: what is on disk goes.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Tout n’a pas pu être enregistré : ce qui est sur le disque vaut.</translation>
  </message>
  <message>
   <source>Nothing was written: no frame is annotated, or none could be written.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Rien n’a été écrit : aucune image n’est annotée, ou aucune n’a pu l’être.</translation>
  </message>
  <message>
   <source>the fit of {frame} is saved as {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>l’ajustement de {frame} est enregistré comme {path}</translation>
  </message>
  <message>
   <source>{source} is made from the clicks it would be scored against: judge the cameras to be scored (procc-annotator calibrate fits and scores a set)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{source} est fait des clics d’après lesquels il serait noté : jugez les caméras à noter (procc-annotator calibrate ajuste et note un jeu)</translation>
  </message>
  <message>
   <source>{annotations} and {scores}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{annotations} et {scores}</translation>
  </message>
  <message>
   <source>nothing: no frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>rien : aucune image n’est annotée</translation>
  </message>
  <message>
   <source>export: cancelled; files that were written already are still there</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>export : annulé ; les fichiers déjà écrits sont encore là</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames</source>
   <extracomment>{n:,} frame / {n:,} frames [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} image</numerusform>
    <numerusform>{n:,} images</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} elements</source>
   <extracomment>{n:,} element / {n:,} elements [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n:,} élément</numerusform>
    <numerusform>{n:,} éléments</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points</source>
   <extracomment>{n:,} point / {n:,} points [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} point</numerusform>
    <numerusform>{n:,} points</numerusform>
   </translation>
  </message>
  <message>
   <source>Zip archive (*.zip);;Folder (*)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Archive zip (*.zip);;Dossier (*)</translation>
  </message>
  <message>
   <source>Save copies to</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Enregistrer des copies dans</translation>
  </message>
  <message numerus="yes">
   <source>copied {n:,} frames to {folder}; they are not saved in their own place yet</source>
   <extracomment>copied {n:,} frame to {folder}; it is not saved in its own place yet / copied {n:,} frames to {folder}; they are not saved in their own place yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image copiée dans {folder} ; elle n’est pas encore enregistrée à sa place</numerusform>
    <numerusform>{n:,} images copiées dans {folder} ; elles ne sont pas encore enregistrées à leur place</numerusform>
   </translation>
  </message>
  <message>
   <source>Table (*.csv);;JSON (*.json)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Table (*.csv);;JSON (*.json)</translation>
  </message>
  <message>
   <source>Table (*.csv)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Table (*.csv)</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} frames to {path}</source>
   <extracomment>exported {n:,} frame to {path} / exported {n:,} frames to {path} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image exportée vers {path}</numerusform>
    <numerusform>{n:,} images exportées vers {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the set was being scored still: some frames have no JaC yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>le jeu était encore en cours de notation : des images n’ont pas encore de JaC</translation>
  </message>
  <message>
   <source>no camera to save: the fit is not there yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>pas de caméra à enregistrer : l’ajustement n’est pas encore là</translation>
  </message>
  <message>
   <source>blind: no frame is committed yet, so there is no JaC to show</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>aveugle : aucune image n’est encore remise, donc pas de JaC à montrer</translation>
  </message>
  <message>
   <source>exported {what} to {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{what} exporté vers {path}</translation>
  </message>
  <message>
   <source>Cancelled; files that were written already are still there.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Annulé ; les fichiers déjà écrits sont encore là.</translation>
  </message>
  <message>
   <source>Not written</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Non écrits</translation>
  </message>
  <message>
   <source>What the format cannot hold</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Ce que le format ne peut pas contenir</translation>
  </message>
  <message>
   <source>everything is saved in its own place</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>tout est enregistré à sa place</translation>
  </message>
  <message>
   <source>no camera to save: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>pas de caméra à enregistrer : {why}</translation>
  </message>
  <message>
   <source>the fit is worked out again: save it in a moment</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>l’ajustement est en cours de recalcul : enregistrez-le dans un instant</translation>
  </message>
  <message>
   <source>{frame}: the picture cannot be read, so that the camera's pixels belong to no size; not saved</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame} : l’image est illisible, si bien que les pixels de la caméra n’ont pas de taille ; non enregistré</translation>
  </message>
  <message>
   <source>saved as {path}, but the loaded cameras could not be read again: {problem}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>enregistré comme {path}, mais les caméras chargées n’ont pu être relues : {problem}</translation>
  </message>
  <message>
   <source>{saved}; it is hardly determined: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{saved} ; il est à peine déterminé : {why}</translation>
  </message>
  <message>
   <source>not everything could be saved: the export has the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>tout n’a pas pu être enregistré : l’export a le dernier état enregistré</translation>
  </message>
  <message numerus="yes">
   <source>blind mode leaves out {n:,} frames not committed yet</source>
   <extracomment>blind mode leaves out {n:,} frame not committed yet / blind mode leaves out {n:,} frames not committed yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>le mode aveugle laisse de côté {n:,} image pas encore remise</numerusform>
    <numerusform>le mode aveugle laisse de côté {n:,} images pas encore remises</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} files could not be read: {problem}</source>
   <extracomment>{n:,} file could not be read: {problem} / {n:,} files could not be read: {problem} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} fichier illisible : {problem}</numerusform>
    <numerusform>{n:,} fichiers illisibles : {problem}</numerusform>
   </translation>
  </message>
  <message>
   <source>Export</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Exporter</translation>
  </message>
  <message>
   <source>exporting {done} / {total}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>export {done} / {total}</translation>
  </message>
  <message>
   <source>Keep the field, and say nothing more of these classes</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Garder le terrain, et ne plus parler de ces classes</translation>
  </message>
  <message>
   <source>The dataset remembers it, and is not asked about again</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Le jeu de données s’en souvient et n’est plus interrogé</translation>
  </message>
  <message>
   <source>No, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Non, {field}</translation>
  </message>
  <message>
   <source>The field of this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Le terrain de ce jeu de données</translation>
  </message>
  <message>
   <source>Descriptions of fields (*.toml)</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Descriptions de terrains (*.toml)</translation>
  </message>
  <message>
   <source>Is this {field}? The classes annotated here are those of {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Est-ce {field} ? Les classes annotées ici sont celles de {field}</translation>
  </message>
  <message>
   <source>{why}, but {file} in the dataset's folder decides</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{why}, mais {file} dans le dossier du jeu décide</translation>
  </message>
  <message>
   <source>Yes, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Oui, {field}</translation>
  </message>
  <message>
   <source>Switch to {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Passer à {field}</translation>
  </message>
  <message>
   <source>{problem}; the field stays as it was: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{problem} ; le terrain est resté ce qu’il était : {field}</translation>
  </message>
  <message>
   <source>Scores then differ from those of the nominal field ({nominal}), as official evaluations take it; they name the dimensions they were computed with.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Les scores diffèrent alors de ceux du terrain nominal ({nominal}), celui des évaluations officielles ; ils nomment les dimensions qui ont servi.</translation>
  </message>
  <message>
   <source>Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is for all others, and for what stadiums leave open.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Dimensions propres (stadiums.csv) : {frames} de {stadiums}. Ce qui est saisi ici vaut pour toutes les autres, et pour ce que les stades laissent ouvert.</translation>
  </message>
  <message>
   <source>Scores then differ from those of official evaluations, which take lines where the rules measure them; they say so.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Les scores diffèrent alors de ceux des évaluations officielles, qui prennent les lignes là où les règles les mesurent ; ils le disent.</translation>
  </message>
  <message>
   <source>Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the paint's width away: choose it where that matters, as in halls and near the camera.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Les règles mesurent beaucoup de lignes à un bord de leur peinture. Les clics sont mis en son milieu, à une demi-largeur : choisissez-le là où cela compte, comme en salle et près de la caméra.</translation>
  </message>
  <message>
   <source>Only length and width are found from frames, and the rules fix those of this field</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Seules la longueur et la largeur se trouvent d’après les images, et les règles fixent celles de ce terrain</translation>
  </message>
  <message numerus="yes">
   <source>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.</source>
   <extracomment>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame. / {dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{dimension} : {value:.2f} ± {sd:.2f} m, d’après {n} image.</numerusform>
    <numerusform>{dimension} : {value:.2f} ± {sd:.2f} m, d’après {n} images.</numerusform>
   </translation>
  </message>
  <message>
   <source>where the rules measure</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>là où les règles mesurent</translation>
  </message>
  <message>
   <source>the middle of the paint</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>le milieu de la peinture</translation>
  </message>
  <message>
   <source>Field dimensions: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Dimensions du terrain : {field}</translation>
  </message>
  <message numerus="yes">
   <source>From the cameras of {n} frames; ± is one standard deviation.</source>
   <extracomment>From the cameras of {n} frame; ± is one standard deviation. / From the cameras of {n} frames; ± is one standard deviation. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>D’après la caméra de {n} image ; ± est un écart type.</numerusform>
    <numerusform>D’après les caméras de {n} images ; ± est un écart type.</numerusform>
   </translation>
  </message>
  <message>
   <source>{remark}; it stays as it was.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>{remark} ; elle est restée ce qu’elle était.</translation>
  </message>
  <message>
   <source>Estimate from this set</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Estimer d’après ce jeu</translation>
  </message>
  <message>
   <source>Clicks lie on:</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Les clics sont sur :</translation>
  </message>
  <message>
   <source>Keep for this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Garder pour ce jeu de données</translation>
  </message>
  <message>
   <source>Nominal</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Nominales</translation>
  </message>
  <message>
   <source>The field as official evaluations take it</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Le terrain tel que le prennent les évaluations officielles</translation>
  </message>
  <message>
   <source>nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>nominal {nominal:g} m, les règles permettent de {minimum:g} à {maximum:g} m</translation>
  </message>
  <message>
   <source>&lt;b&gt;not {number:g} m: the rules allow {minimum:g} to {maximum:g} m&lt;/b&gt;</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>&lt;b&gt;pas {number:g} m : les règles permettent de {minimum:g} à {maximum:g} m&lt;/b&gt;</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames</source>
   <extracomment>{n} frame / {n} frames [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} image</numerusform>
    <numerusform>{n} images</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} stadiums</source>
   <extracomment>{n} stadium / {n} stadiums [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} stade</numerusform>
    <numerusform>{n} stades</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: frames that are not committed took no part ({n}).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Aveugle : les images non remises n’ont pas participé ({n}).</translation>
  </message>
  <message>
   <source>Frames that cannot be read took no part: {n}.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Les images illisibles n’ont pas participé : {n}.</translation>
  </message>
  <message>
   <source>Stop</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py, procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Arrêter</translation>
  </message>
  <message>
   <source>the rules fix every dimension of the field {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>les règles fixent toutes les dimensions du terrain {field}</translation>
  </message>
  <message>
   <source>Blind: the set is checked once one of its frames is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Aveugle : le jeu est regardé dès qu’une de ses images est remise (Ctrl+Entrée).</translation>
  </message>
  <message>
   <source>no further frame this way: {what}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>plus d’image dans ce sens : {what}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: JaC {value:.3f}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} sur {total}, les pires d’abord : JaC {value:.3f}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: largest error {value:.1f} px</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} sur {total}, les pires d’abord : plus grande erreur {value:.1f} px</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: median disagreement {value:.2f} m</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} sur {total}, les pires d’abord : désaccord médian {value:.2f} m</translation>
  </message>
  <message>
   <source>{place} of {total}, the least sure first</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} sur {total}, les moins sûres d’abord</translation>
  </message>
  <message>
   <source>none is annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune n’est annotée</translation>
  </message>
  <message>
   <source>all are annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>toutes sont annotées</translation>
  </message>
  <message>
   <source>all are done or approved</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>toutes sont terminées ou approuvées</translation>
  </message>
  <message>
   <source>none is rejected</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune n’est rejetée</translation>
  </message>
  <message>
   <source>this is the last one</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>c’est la dernière</translation>
  </message>
  <message>
   <source>no frame with a score to go to</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune image notée où aller</translation>
  </message>
  <message>
   <source>no frame with a score to go to: blind mode shows those of committed frames only</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune image notée où aller : le mode aveugle ne montre que les images remises</translation>
  </message>
  <message>
   <source>comparing {source} with {other} over the set</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>comparaison de {source} et {other} sur le jeu</translation>
  </message>
  <message>
   <source>blind mode: how the track does is hidden</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>mode aveugle : ce que vaut le suivi est caché</translation>
  </message>
  <message>
   <source>no shot was followed yet (T)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucun plan n’a encore été suivi (T)</translation>
  </message>
  <message>
   <source>no other frame is unsure</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune autre image n’est incertaine</translation>
  </message>
  <message>
   <source>these frames do not follow one another</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ces images ne se suivent pas</translation>
  </message>
  <message>
   <source>two sources are needed to see where they disagree: load more cameras (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>il faut deux sources pour voir où elles divergent : chargez plus de caméras (Ctrl+L)</translation>
  </message>
  <message>
   <source>{source} and {other} cannot be compared on the ground in any frame</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} et {other} ne peuvent être comparées au sol sur aucune image</translation>
  </message>
  <message>
   <source>stopped comparing the sources</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>comparaison des sources arrêtée</translation>
  </message>
  <message>
   <source>this is the worst; once more goes on</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>c’est la pire ; une fois de plus continue</translation>
  </message>
  <message>
   <source>no other frame has a score</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune autre image n’est notée</translation>
  </message>
  <message>
   <source>from the worst again</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>à partir de la pire à nouveau</translation>
  </message>
  <message>
   <source>two sources are being compared already</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>deux sources sont déjà en cours de comparaison</translation>
  </message>
  <message>
   <source>{source} and {other} are compared</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} et {other} sont comparées</translation>
  </message>
  <message>
   <source>none is doubtful</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aucune n’est douteuse</translation>
  </message>
  <message>
   <source>skipped (under {least:.0%} visible): {ghosts}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>omis (moins de {least:.0%} visible) : {ghosts}</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/commands/ghost_accepting.py, procc_annotator/gui/commands/versions.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>
    <numerusform>{n} point</numerusform>
    <numerusform>{n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>{accepted}: {points}, line seen along {share:.0%}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{accepted} : {points}, ligne vue sur {share:.0%}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ends of {elements} cannot be seen: the points stop before</source>
   <extracomment>{n} end of {elements} cannot be seen: the points stop before / {n} ends of {elements} cannot be seen: the points stop before [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} bout de {elements} ne se voit pas : les points s’arrêtent avant</numerusform>
    <numerusform>{n} bouts de {elements} ne se voient pas : les points s’arrêtent avant</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera is another one meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>la caméra est une autre entre-temps</translation>
  </message>
  <message>
   <source>accept {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>accepter {what}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts</source>
   <extracomment>{n} ghost / {n} ghosts [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} fantôme</numerusform>
    <numerusform>{n} fantômes</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ghosts</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{n} fantômes sur {total}</translation>
  </message>
  <message>
   <source>accepted {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} accepté</translation>
  </message>
  <message>
   <source>the frame was edited meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>l’image a été modifiée entre-temps</translation>
  </message>
  <message>
   <source>looking for the line on {frame} took too long</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>la recherche de la ligne sur {frame} a pris trop de temps</translation>
  </message>
  <message>
   <source>{element} is not accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} n’est pas accepté : {why}</translation>
  </message>
  <message>
   <source>{element}: no painted line is found along it; click it by hand, or say that it is not visible here (.)</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} : aucune ligne peinte n’est trouvée dessus ; cliquez-le à la main, ou dites qu’il n’est pas visible ici (.)</translation>
  </message>
  <message>
   <source>the camera is being fitted: accept its ghosts in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>la caméra est en cours d’ajustement : acceptez ses fantômes dans un instant</translation>
  </message>
  <message>
   <source>no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes through them</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>aucun fantôme accepté, moins de {least:.0%} de la ligne visible : {ghosts} ; Tab les parcourt</translation>
  </message>
  <message>
   <source>accepted {what} on {frame}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} accepté sur {frame}</translation>
  </message>
  <message>
   <source>no ghost was accepted: there is no picture to look for their lines in</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>aucun fantôme accepté : il n’y a pas d’image où chercher leurs lignes</translation>
  </message>
  <message>
   <source>no ghost was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>aucun fantôme accepté : {why}</translation>
  </message>
  <message>
   <source>{element} is not accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} n’est pas accepté</translation>
  </message>
  <message>
   <source>the ghost is accepted: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>le fantôme est accepté : acceptez les fantômes du nouvel ajustement</translation>
  </message>
  <message>
   <source>what was being drawn is finished: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>ce qui était dessiné est terminé : acceptez les fantômes du nouvel ajustement</translation>
  </message>
  <message>
   <source>no ghost was accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>aucun fantôme accepté</translation>
  </message>
  <message>
   <source>{element} is accepted once its points are found</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} est accepté dès que ses points sont trouvés</translation>
  </message>
  <message>
   <source>go to a ghost (Tab) or choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>allez d’abord à un fantôme (Tab) ou choisissez un élément</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts left, Tab begins again</source>
   <extracomment>{n} ghost left, Tab begins again / {n} ghosts left, Tab begins again [procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>
    <numerusform>il reste {n} fantôme, Tab recommence</numerusform>
    <numerusform>il reste {n} fantômes, Tab recommence</numerusform>
   </translation>
  </message>
  <message>
   <source>that was the last ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>c’était le dernier fantôme</translation>
  </message>
  <message>
   <source>that was the first ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>c’était le premier fantôme</translation>
  </message>
  <message>
   <source>the camera is being fitted: ghosts come in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>la caméra est en cours d’ajustement : les fantômes arrivent</translation>
  </message>
  <message>
   <source>no ghosts: the camera is looked for in the picture</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : la caméra est recherchée dans l’image</translation>
  </message>
  <message>
   <source>no ghosts: no camera is known; {advice}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : aucune caméra connue ; {advice}</translation>
  </message>
  <message>
   <source>no ghosts: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : {why}</translation>
  </message>
  <message>
   <source>no ghosts: what else is in sight is annotated, or not known well enough</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : le reste en vue est annoté, ou pas assez bien connu</translation>
  </message>
  <message>
   <source>no ghosts: they are switched off (Element &gt; Ghosts &gt; Show ghosts)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : ils sont désactivés (Élément &gt; Fantômes &gt; Afficher les fantômes)</translation>
  </message>
  <message>
   <source>overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>les superpositions sont cachées : aucun fantôme ne se voit (Ctrl+H, ou lâchez X)</translation>
  </message>
  <message>
   <source>finish what is being drawn first (Enter), or cancel it (Esc)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>terminez d’abord ce qui est dessiné (Entrée), ou abandonnez-le (Échap)</translation>
  </message>
  <message>
   <source>no ghosts: no camera could be fitted</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>pas de fantômes : aucune caméra n’a pu être ajustée</translation>
  </message>
  <message>
   <source>no camera fits yet</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>aucune caméra ne s’ajuste encore</translation>
  </message>
  <message>
   <source>it is being drawn by hand</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>il est dessiné à la main</translation>
  </message>
  <message>
   <source>{title} is annotated here: delete it first (Ctrl+Delete)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} est annoté ici : supprimez-le d’abord (Ctrl+Suppr)</translation>
  </message>
  <message>
   <source>{title} is not visible here; Ctrl+. takes it back</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} n’est pas visible ici ; Ctrl+. l’annule</translation>
  </message>
  <message>
   <source>{title} may be visible here again</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} est peut-être de nouveau visible ici</translation>
  </message>
  <message>
   <source>no element of this frame was said to be not visible</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>aucun élément de cette image n’a été dit non visible</translation>
  </message>
  <message>
   <source>go to a ghost first (Tab)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>allez d’abord à un fantôme (Tab)</translation>
  </message>
  <message>
   <source>{off}; choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{off} ; choisissez d’abord un élément</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported ({format}).</source>
   <extracomment>{edited} of {n:,} frame imported ({format}). / {edited} of {n:,} frames imported ({format}). [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} sur {n:,} image importée ({format}).</numerusform>
    <numerusform>{edited} sur {n:,} images importées ({format}).</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Cancelled: {n:,} frames were not checked.</source>
   <extracomment>Cancelled: {n:,} frame was not checked. / Cancelled: {n:,} frames were not checked. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>Annulé : {n:,} image n’a pas été regardée.</numerusform>
    <numerusform>Annulé : {n:,} images n’ont pas été regardées.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are annotated already and left unchanged.</source>
   <extracomment>{n:,} frame is annotated already and left unchanged. / {n:,} frames are annotated already and left unchanged. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} image est déjà annotée et reste inchangée.</numerusform>
    <numerusform>{n:,} images sont déjà annotées et restent inchangées.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames hold the same already.</source>
   <extracomment>{n:,} frame holds the same already. / {n:,} frames hold the same already. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} image contient déjà la même chose.</numerusform>
    <numerusform>{n:,} images contiennent déjà la même chose.</numerusform>
   </translation>
  </message>
  <message>
   <source>import</source>
   <comment>a step</comment>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>importer</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported</source>
   <extracomment>{edited} of {n:,} frame imported / {edited} of {n:,} frames imported [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} sur {n:,} image importée</numerusform>
    <numerusform>{edited} sur {n:,} images importées</numerusform>
   </translation>
  </message>
  <message>
   <source>Cancelled; nothing was imported.</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Annulé ; rien n’a été importé.</translation>
  </message>
  <message>
   <source>Left as they were</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Laissées telles quelles</translation>
  </message>
  <message>
   <source>Could not be read</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Illisibles</translation>
  </message>
  <message>
   <source>Without a picture here ({n})</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Sans image ici ({n})</translation>
  </message>
  <message>
   <source>Changed or left out</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Changées ou laissées de côté</translation>
  </message>
  <message>
   <source>it could not be saved: {why}</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>elle n’a pas pu être enregistrée : {why}</translation>
  </message>
  <message>
   <source>error</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>erreur</translation>
  </message>
  <message>
   <source>warning</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>avertissement</translation>
  </message>
  <message>
   <source>hint</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>remarque</translation>
  </message>
  <message>
   <source>finding {place} of {total}, {severity}: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>constat {place} sur {total}, {severity} : {elements}</translation>
  </message>
  <message>
   <source>no finding is as sure as the Check panel is set to show</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>aucun constat n’est aussi sûr que le panneau Vérification le demande</translation>
  </message>
  <message numerus="yes">
   <source>relabelled {n} elements</source>
   <extracomment>relabelled {n} element / relabelled {n} elements [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n} élément renommé</numerusform>
    <numerusform>{n} éléments renommés</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>checked {n:,} frames, camera model {model}: {found}</source>
   <extracomment>checked {n:,} frame, camera model {model}: {found} / checked {n:,} frames, camera model {model}: {found} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} image vérifiée, modèle de caméra {model} : {found}</numerusform>
    <numerusform>{n:,} images vérifiées, modèle de caméra {model} : {found}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} checked frames</source>
   <extracomment>{n:,} checked frame / {n:,} checked frames [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} image vérifiée</numerusform>
    <numerusform>{n:,} images vérifiées</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} et {other}</translation>
  </message>
  <message>
   <source>the label check is still looking at this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la vérification des classes examine encore cette image</translation>
  </message>
  <message>
   <source>the label check has found nothing; check the whole set to look at all frames</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la vérification des classes n’a rien trouvé ; vérifiez tout le jeu pour voir toutes les images</translation>
  </message>
  <message>
   <source>{done}; Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{done} ; Ctrl+Z l’annule</translation>
  </message>
  <message>
   <source>removed point {n} of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>point {n} de {element} retiré</translation>
  </message>
  <message>
   <source>swapped {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} et {other} échangés</translation>
  </message>
  <message>
   <source>relabelled {element} to {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} renommé en {other}</translation>
  </message>
  <message>
   <source>ignored until {elements} changes; the Check panel brings it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>ignoré jusqu’à ce que {elements} change ; le panneau Vérification le ramène</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked</source>
   <extracomment>{n:,} frame cannot be checked / {n:,} frames cannot be checked [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} image ne peut être vérifiée</numerusform>
    <numerusform>{n:,} images ne peuvent être vérifiées</numerusform>
   </translation>
  </message>
  <message>
   <source>Export findings</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Exporter les constats</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} findings in {frames} to {path}</source>
   <extracomment>exported {n:,} finding in {frames} to {path} / exported {n:,} findings in {frames} to {path} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} constat de {frames} exporté vers {path}</numerusform>
    <numerusform>{n:,} constats de {frames} exportés vers {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the label check has found nothing</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la vérification des classes n’a rien trouvé</translation>
  </message>
  <message>
   <source>the elements have changed since: checked again</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>les éléments ont changé depuis : vérifiés à nouveau</translation>
  </message>
  <message>
   <source>removed point of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>point de {element} retiré</translation>
  </message>
  <message>
   <source>go to a finding first (F10)</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>allez d’abord à un constat (F10)</translation>
  </message>
  <message>
   <source>stopped checking the set; what was found stays</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>vérification du jeu arrêtée ; ce qui a été trouvé reste</translation>
  </message>
  <message>
   <source>the label check has found nothing in this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la vérification des classes n’a rien trouvé sur cette image</translation>
  </message>
  <message>
   <source>nothing found</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>rien trouvé</translation>
  </message>
  <message>
   <source>no remedy is known: {reason}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>aucun remède connu : {reason}</translation>
  </message>
  <message>
   <source>cameras opened here before are not opened again: {why}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>des caméras ouvertes ici auparavant ne sont pas rouvertes : {why}</translation>
  </message>
  <message>
   <source>Open a video</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ouvrir une vidéo</translation>
  </message>
  <message>
   <source>One frame every</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Une image toutes les</translation>
  </message>
  <message>
   <source>The first frame of every scene</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>La première image de chaque scène</translation>
  </message>
  <message>
   <source>Looks through the whole video for cuts; this takes a while</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Cherche les coupes dans toute la vidéo ; cela prend un moment</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, the field american_football, the menus]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>Reading {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Lecture de {file}</translation>
  </message>
  <message>
   <source>Looking for cuts in {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Recherche de coupes dans {file}</translation>
  </message>
  <message>
   <source>Pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Images</translation>
  </message>
  <message>
   <source>Videos</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Vidéos</translation>
  </message>
  <message>
   <source>Nothing is extracted; “Keep this video frame” writes a picture.</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Rien n’est extrait ; « Garder cette image de la vidéo » écrit un fichier.</translation>
  </message>
  <message>
   <source>cameras opened here before are not there any more: {paths}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>des caméras ouvertes ici auparavant ne sont plus là : {paths}</translation>
  </message>
  <message>
   <source>this frame is a picture already</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>cette image est déjà un fichier</translation>
  </message>
  <message>
   <source>kept as {path}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>gardée comme {path}</translation>
  </message>
  <message>
   <source>the sample comes with the source, not here</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/tour.py]</extracomment>
   <translation>l’exemple vient avec le code source, pas ici</translation>
  </message>
  <message>
   <source>your own copy, in {folder}; load its cameras from the menu Camera</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>votre propre copie, dans {folder} ; chargez ses caméras par le menu Caméra</translation>
  </message>
  <message>
   <source>Load a folder of cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Charger un dossier de caméras</translation>
  </message>
  <message>
   <source>Load cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Charger des caméras</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Caméras</translation>
  </message>
  <message>
   <source>Open a folder of pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ouvrir un dossier d’images</translation>
  </message>
  <message>
   <source>Open a picture</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ouvrir une image</translation>
  </message>
  <message>
   <source>Open a second annotator's folder</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ouvrir le dossier d’un second annotateur</translation>
  </message>
  <message>
   <source>{width} x {height} px, without the legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, sans la légende</translation>
  </message>
  <message>
   <source>{width} x {height} px, too large: choose a smaller scale or SVG</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, trop grand : choisissez une échelle plus petite ou SVG</translation>
  </message>
  <message>
   <source>PNG: pixels, nothing is lost</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>PNG : pixels, rien n’est perdu</translation>
  </message>
  <message>
   <source>JPEG: pixels, small</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>JPEG : pixels, petit</translation>
  </message>
  <message>
   <source>SVG: lines and text stay sharp</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>SVG : lignes et texte restent nets</translation>
  </message>
  <message>
   <source>Picture (*{suffix})</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Image (*{suffix})</translation>
  </message>
  <message>
   <source>Save overlay picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Enregistrer l’image superposée</translation>
  </message>
  <message>
   <source>Px of the result per px of the picture; lines and text grow with it</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Px du résultat par px de l’image ; lignes et texte grandissent avec elle</translation>
  </message>
  <message>
   <source>Explain colours, dashes and marks below the picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Expliquer couleurs, tirets et marques sous l’image</translation>
  </message>
  <message>
   <source>&amp;Kind</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Type</translation>
  </message>
  <message>
   <source>&amp;Scale</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Échelle</translation>
  </message>
  <message>
   <source>Result</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Résultat</translation>
  </message>
  <message>
   <source>&amp;Legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Légende</translation>
  </message>
  <message>
   <source>writing the overlay picture {path} …</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>écriture de l’image superposée {path} …</translation>
  </message>
  <message>
   <source>open a picture first</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>ouvrez d’abord une image</translation>
  </message>
  <message>
   <source>{path}: is the picture itself, choose another name</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{path} : est l’image elle-même, choisissez un autre nom</translation>
  </message>
  <message>
   <source>overlay picture written to {path}</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>image superposée écrite dans {path}</translation>
  </message>
  <message>
   <source>waiting</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>en attente</translation>
  </message>
  <message>
   <source>begun</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>commencé</translation>
  </message>
  <message>
   <source>done</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>terminé</translation>
  </message>
  <message>
   <source>failed</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>échoué</translation>
  </message>
  <message>
   <source>Match</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Match</translation>
  </message>
  <message>
   <source>Stadium</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Stade</translation>
  </message>
  <message>
   <source>Start</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Début</translation>
  </message>
  <message>
   <source>State</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>État</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/commands/season.py, procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Images</translation>
  </message>
  <message>
   <source>Tracked</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Suivies</translation>
  </message>
  <message>
   <source>On paint</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Sur la peinture</translation>
  </message>
  <message>
   <source>Failed units</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Unités échouées</translation>
  </message>
  <message>
   <source>Season</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Saison</translation>
  </message>
  <message>
   <source>Search: match, stadium, state</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Chercher : match, stade, état</translation>
  </message>
  <message>
   <source>Tracked cameras…</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Caméras suivies…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} matches</source>
   <extracomment>{n:,} match / {n:,} matches [procc_annotator/gui/commands/season.py]</extracomment>
   <translation>
    <numerusform>{n:,} match</numerusform>
    <numerusform>{n:,} matchs</numerusform>
   </translation>
  </message>
  <message>
   <source>The folder that track writes to</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Le dossier dans lequel track écrit</translation>
  </message>
  <message>
   <source>Matches</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Matchs</translation>
  </message>
  <message>
   <source>open a season first: a folder in which videos lie, or a list of them</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>ouvrez d’abord une saison : un dossier qui contient des vidéos, ou une liste de celles-ci</translation>
  </message>
  <message>
   <source>it is annotated by now</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>elle est annotée entre-temps</translation>
  </message>
  <message>
   <source>it was edited since</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>elle a été modifiée depuis</translation>
  </message>
  <message>
   <source>no frame to accept: follow the shot first (T)</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aucune image à accepter : suivez d’abord le plan (T)</translation>
  </message>
  <message>
   <source>the shot is still being followed: wait for its end, or stop it (T), then accept</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>le suivi du plan est en cours : attendez sa fin ou arrêtez-le (T), puis acceptez</translation>
  </message>
  <message>
   <source>no frame to accept: all that were followed are annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aucune image à accepter : toutes celles qui ont été suivies sont annotées</translation>
  </message>
  <message>
   <source>every frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>toutes les images sont annotées</translation>
  </message>
  <message>
   <source>blind mode: nothing is accepted that was not clicked</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>mode aveugle : rien n’est accepté qui n’ait été cliqué</translation>
  </message>
  <message numerus="yes">
   <source>all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it / all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image est douteuse ({why}) : regardez-la ; Ctrl+Maj+Entrée encore une fois l’accepte</numerusform>
    <numerusform>les {n:,} images sont douteuses ({why}) : regardez-en quelques-unes ; Ctrl+Maj+Entrée encore une fois les accepte</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points: {done} of {total} frames  ·  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>recherche des points de ligne : {done} images sur {total}  ·  Échap arrête</translation>
  </message>
  <message>
   <source>accept elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>accepter des éléments</translation>
  </message>
  <message>
   <source>take back accepted elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>revenir sur les éléments acceptés</translation>
  </message>
  <message numerus="yes">
   <source>annotated {n:,} frames</source>
   <extracomment>annotated {n:,} frame / annotated {n:,} frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image annotée</numerusform>
    <numerusform>{n:,} images annotées</numerusform>
   </translation>
  </message>
  <message>
   <source>Ctrl+Z takes them back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Ctrl+Z les annule</translation>
  </message>
  <message numerus="yes">
   <source>taken back: {n:,} annotated frames</source>
   <extracomment>taken back: {n:,} annotated frame / taken back: {n:,} annotated frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>annulé : {n:,} image annotée</numerusform>
    <numerusform>annulé : {n:,} images annotées</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames left: {why}</source>
   <extracomment>{n:,} frame left: {why} / {n:,} frames left: {why} [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image laissée : {why}</numerusform>
    <numerusform>{n:,} images laissées : {why}</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points …  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>recherche des points de ligne …  Échap arrête</translation>
  </message>
  <message>
   <source>no frame was annotated: too little of their lines is seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aucune image annotée : trop peu de leurs lignes se voit</translation>
  </message>
  <message>
   <source>no frame was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aucune image acceptée : {why}</translation>
  </message>
  <message>
   <source>nothing was accepted that could be taken back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>rien n’a été accepté qui puisse être annulé</translation>
  </message>
  <message>
   <source>taken back: no frame is accepted</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>annulé : aucune image n’est acceptée</translation>
  </message>
  <message>
   <source>no frame was annotated: no camera is sure</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aucune image annotée : aucune caméra n’est sûre</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first</source>
   <extracomment>{n:,} frame is not sure: Alt+PgDown shows it / {n:,} frames are not sure: Alt+PgDown goes through them, the least sure first [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image n’est pas sûre : Alt+Page suiv. l’affiche</numerusform>
    <numerusform>{n:,} images ne sont pas sûres : Alt+Page suiv. les parcourt, les moins sûres d’abord</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it / {n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} image douteuse laissée : Ctrl+Maj+Entrée encore une fois l’accepte</numerusform>
    <numerusform>{n:,} images douteuses laissées : Ctrl+Maj+Entrée encore une fois les accepte</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera of this frame is unsure: a sure one is looked for in the shot; look at this one, accept its lines (Shift+Enter), then T follows them</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>la caméra de cette image n’est pas sûre : une caméra sûre est cherchée dans le plan ; regardez celle-ci, acceptez ses lignes (Maj+Entrée), puis T les suit</translation>
  </message>
  <message>
   <source>no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or {advice}; then T follows it</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>aucune image du plan n’a de caméra sûre : acceptez les lignes de l’une d’elles (Maj+Entrée), ou {advice} ; ensuite T la suit</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} image suivie, dont {doubtful:,} douteuses (Alt+Page suiv.) ; Ctrl+Maj+Entrée accepte les sûres</numerusform>
    <numerusform>{n:,} images suivies, dont {doubtful:,} douteuses (Alt+Page suiv.) ; Ctrl+Maj+Entrée accepte les sûres</numerusform>
   </translation>
  </message>
  <message>
   <source>following: {done} of {total} frames  ·  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>suivi : {done} images sur {total}  ·  T arrête</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} image suivie, sûre ; Ctrl+Maj+Entrée accepte les sûres</numerusform>
    <numerusform>{n:,} images suivies, toutes sûres ; Ctrl+Maj+Entrée accepte les sûres</numerusform>
   </translation>
  </message>
  <message>
   <source>looking for the ends of the shot …  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>recherche des bouts du plan …  T arrête</translation>
  </message>
  <message>
   <source>the shot could not be followed: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>le plan n’a pu être suivi : {why}</translation>
  </message>
  <message>
   <source>only a video, or frames that follow one another, can be followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>seule une vidéo, ou des images qui se suivent, peut être suivie</translation>
  </message>
  <message>
   <source>blind mode: no shot is followed, its cameras would be seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>mode aveugle : aucun plan n’est suivi, on verrait ses caméras</translation>
  </message>
  <message>
   <source>stopped; what was followed so far stays</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>arrêté ; ce qui est suivi jusqu’ici reste</translation>
  </message>
  <message>
   <source>stopped; nothing was followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>arrêté ; rien n’a été suivi</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Lever le mode aveugle montre caméras, fantômes et ajustement à tous ceux qui annotent ce jeu. Il est consigné avec le jeu que {author} l’a levé, et quand.</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Lever le mode aveugle vous montre caméras, fantômes et ajustement ; pour les autres il n’était pas imposé. Il est consigné avec le jeu que {author} l’a levé, et quand.</translation>
  </message>
  <message>
   <source>blind mode leaves out {n} on frames that are not committed</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>le mode aveugle laisse de côté {n} sur des images non remises</translation>
  </message>
  <message>
   <source>{frame}: no verdict on {source} any more</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{frame} : plus de verdict sur {source}</translation>
  </message>
  <message>
   <source>Note on the verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Note sur le verdict</translation>
  </message>
  <message>
   <source>What is wrong here:</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Ce qui est faux ici :</translation>
  </message>
  <message>
   <source>Export verdicts</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Exporter les verdicts</translation>
  </message>
  <message>
   <source>blind: no frame that is committed has a verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>aveugle : aucune image remise n’a de verdict</translation>
  </message>
  <message>
   <source>no frame has a verdict yet: mark one first</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>aucune image n’a encore de verdict : rendez-en d’abord un</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} verdicts to {path}</source>
   <extracomment>exported {n:,} verdict to {path} / exported {n:,} verdicts to {path} [procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>
    <numerusform>{n:,} verdict exporté vers {path}</numerusform>
    <numerusform>{n:,} verdicts exportés vers {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>mark the frame first: camera wrong, labels wrong or fine</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>jugez d’abord l’image : caméra fausse, annotation fausse ou OK</translation>
  </message>
  <message>
   <source>not everything could be saved: the figures are of the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>tout n’a pas pu être enregistré : les chiffres sont ceux du dernier état enregistré</translation>
  </message>
  <message>
   <source>{source} follows the clicks: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} suit les clics : un verdict porte sur une caméra chargée</translation>
  </message>
  <message>
   <source>{source} is worked out here: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} est calculée ici : un verdict porte sur une caméra chargée</translation>
  </message>
  <message>
   <source>There is no earlier version of this frame.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Il n’y a pas de version antérieure de cette image.</translation>
  </message>
  <message>
   <source>Compared with now: {changes}. What differs: {elements}.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Comparé à maintenant : {changes}. Ce qui diffère : {elements}.</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>illisible</translation>
  </message>
  <message>
   <source>empty</source>
   <comment>a version</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>vide</translation>
  </message>
  <message>
   <source>as now</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>comme maintenant</translation>
  </message>
  <message>
   <source>other elements</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>autres éléments</translation>
  </message>
  <message>
   <source>points moved</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>points déplacés</translation>
  </message>
  <message>
   <source>This is what the frame holds now.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>C’est ce que l’image contient maintenant.</translation>
  </message>
  <message>
   <source>Compared with now: the same points in another order of elements.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Comparé à maintenant : les mêmes points dans un autre ordre d’éléments.</translation>
  </message>
  <message>
   <source>restore an earlier version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>restaurer une version antérieure</translation>
  </message>
  <message>
   <source>Earlier versions</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Versions antérieures</translation>
  </message>
  <message>
   <source>Restore</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Restaurer</translation>
  </message>
  <message>
   <source>%d %b %Y, %H:%M:%S</source>
   <comment>a moment; the month as %b is English, as %m a number</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>%d/%m/%Y, %H:%M:%S</translation>
  </message>
  <message>
   <source>{n} more</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>{n} de plus</translation>
  </message>
  <message>
   <source>the earlier version is back; undo takes it away again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>la version antérieure est revenue ; annuler l’enlève à nouveau</translation>
  </message>
  <message>
   <source>the earlier version is back; what could not be read stays a version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>la version antérieure est de retour ; ce qui était illisible reste comme version</translation>
  </message>
  <message>
   <source>the frame was changed elsewhere: look at it, then restore again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>l’image a été changée ailleurs : regardez-la, puis restaurez à nouveau</translation>
  </message>
  <message>
   <source>Frames of one instant from different cameras are one group. Their names tell which, by a pattern: &lt;b&gt;{instant}&lt;/b&gt; stands for when a frame was taken, &lt;b&gt;{view}&lt;/b&gt; for the camera, all else for itself. A regular expression with &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; and &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; does it, too.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Les images d’un même instant depuis plusieurs caméras forment un groupe. Leurs noms le disent, selon un motif : &lt;b&gt;{instant}&lt;/b&gt; y tient lieu du moment de la prise, &lt;b&gt;{view}&lt;/b&gt; de la caméra, et tout le reste de lui-même. Une expression régulière avec &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; et &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; convient aussi.</translation>
  </message>
  <message>
   <source>No pattern was found that fits these names: write one.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Aucun motif trouvé qui convienne à ces noms : écrivez-en un.</translation>
  </message>
  <message>
   <source>What it says now is lost, with everything else that is written in it.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Ce qu’il dit maintenant est perdu, avec tout ce qui y est écrit.</translation>
  </message>
  <message>
   <source>Instant</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Instant</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups of {least} to {most}</source>
   <extracomment>{frames} in {n:,} group of {least} to {most} / {frames} in {n:,} groups of {least} to {most} [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} en {n:,} groupe de {least} à {most}</numerusform>
    <numerusform>{frames} en {n:,} groupes de {least} à {most}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} of {n:,} instants</source>
   <extracomment>{frames} of {n:,} instant / {frames} of {n:,} instants [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} de {n:,} instant</numerusform>
    <numerusform>{frames} de {n:,} instants</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames, none grouped.</source>
   <extracomment>{n:,} frame, none grouped. / {n:,} frames, none grouped. [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} image, non groupée.</numerusform>
    <numerusform>{n:,} images, aucune groupée.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups</source>
   <extracomment>{frames} in {n:,} group / {frames} in {n:,} groups [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} en {n:,} groupe</numerusform>
    <numerusform>{frames} en {n:,} groupes</numerusform>
   </translation>
  </message>
  <message>
   <source>This name does not fit the pattern: the frame stands alone</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Ce nom ne suit pas le motif : l’image reste seule</translation>
  </message>
  <message>
   <source>{file} groups {sizes} from now on</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} groupe désormais {sizes}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} instants with one frame only</source>
   <extracomment>{n:,} instant with one frame only / {n:,} instants with one frame only [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} instant avec une seule image</numerusform>
    <numerusform>{n:,} instants avec une seule image</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} names do not fit (last in the table)</source>
   <extracomment>{n:,} name does not fit (last in the table) / {n:,} names do not fit (last in the table) [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} nom ne convient pas (à la fin de la table)</numerusform>
    <numerusform>{n:,} noms ne conviennent pas (à la fin de la table)</numerusform>
   </translation>
  </message>
  <message>
   <source>Group views</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Grouper les vues</translation>
  </message>
  <message>
   <source>{file} is there already: {sizes}.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} existe déjà : {sizes}.</translation>
  </message>
  <message>
   <source>Write {file}</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Écrire {file}</translation>
  </message>
  <message>
   <source>Keep these groups in the dataset's folder</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Garder ces groupes dans le dossier du jeu</translation>
  </message>
  <message>
   <source>Groups of frames</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Groupes d’images</translation>
  </message>
  <message>
   <source>Pattern of the frames' names</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Motif des noms d’images</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} élément, symétries : {turns}</numerusform>
    <numerusform>{n} éléments, symétries : {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Il n’y a pas encore de terrain à montrer.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension} : {value:.10g} m (les règles permettent de {least:g} à {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... et {n} de plus</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>aucune</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ce qui se tient enfoncé dans l’image</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Habituelles</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Gaucher</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Comme CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Comme labelme</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Molette</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>zoom au curseur</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Deux doigts</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>déplacer ; pincés, zoom</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Maj + molette</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>déplacer de côté, comme une molette inclinée</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Espace + glisser</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>déplacer</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bouton du milieu</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Tenir X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>cacher toutes les superpositions</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Tenir Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>loupe : huit fois les pixels de l’image</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Tenir ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>regarder la source de caméras comparée</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Taper ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>juger avec la source comparée, comparer avec celle-ci</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Tenir Ctrl</translation>
  </message>
  <message>
   <source>click off the line: no snapping</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>cliquer à côté de la ligne : sans aimant</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + glisser une ligne</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>caméra : elle suit, l’endroit reste comme piquet</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + cliquer un piquet</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>caméra : retirer le piquet</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/keymap.py, procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flèches</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>réticule : les touches pointent ; les points choisis sont plutôt déplacés</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Espace au réticule</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ce qu’un clic y fait (avec Ctrl : sans aimant)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bouton droit</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>menu de ce qui est sous le curseur</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Entrée</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>accepter le fantôme actuel</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Maj+Entrée</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>accepter tous les fantômes</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Clic</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>dessin : ajouter un point</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Double-clic</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>dessin : terminer</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Glisser un point</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : le déplacer</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Maj+clic sur un point</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : en choisir plusieurs</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Glisser sur un endroit vide</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : choisir les points à l’intérieur</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Glisser une ligne</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : déplacer l’élément, sauf si les éléments sont épinglés</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+clic sur une ligne</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : insérer un point</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Maj+clic</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>édition : retirer le point</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Cliquer ou glisser sur la bande</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>aller à une image</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Molette sur la bande</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>zoom ; avec Maj, défiler</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Maj+glisser sur la bande</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>marquer un passage (un double-clic le lâche)</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>attendu : un objet avec "actions" et "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" et "elements" : des objets sont attendus</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place} : {value!r} n’est pas une touche ; il en faut une comme {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place} : une liste de touches est attendue, comme {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Panneaux</translation>
  </message>
  <message>
   <source>Choose another place…</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Choisir un autre lieu…</translation>
  </message>
  <message>
   <source>Save copies to…</source>
   <extracomment>[procc_annotator/gui/messages.py, the action save_copies]</extracomment>
   <translation>Enregistrer des copies dans…</translation>
  </message>
  <message>
   <source>Copy details</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Copier les détails</translation>
  </message>
  <message>
   <source>Show the next</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Afficher la suivante</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} existe déjà, et dit autre chose.</translation>
  </message>
  <message numerus="yes">
   <source>{n} comments on this frame are not settled.</source>
   <extracomment>{n} comment on this frame is not settled. / {n} comments on this frame are not settled. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} commentaire sur cette image n’est pas réglé.</numerusform>
    <numerusform>{n} commentaires sur cette image ne sont pas réglés.</numerusform>
   </translation>
  </message>
  <message>
   <source>A tick in the Review panel settles a comment.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Une coche dans le panneau « Relecture » règle un commentaire.</translation>
  </message>
  <message>
   <source>{n:,} of {total:,} frames are not done.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{n:,} images sur {total:,} ne sont pas terminées.</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} image n’est pas enregistrée, et l’enregistrement vient d’échouer encore.</numerusform>
    <numerusform>{n} images ne sont pas enregistrées, et l’enregistrement vient d’échouer encore.</numerusform>
   </translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Montrer ce qui est dans le fichier ; annuler ramène votre version</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Écrire ce que vous voyez par-dessus le fichier</translation>
  </message>
  <message>
   <source>Export all</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Tout exporter</translation>
  </message>
  <message>
   <source>Done only</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Terminées seulement</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fermer ce message</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Recharger les leurs</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Écraser avec les miennes</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Supprimer {what} ?</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Le garder</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Supprimer</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Le remplacer</translation>
  </message>
  <message>
   <source>Do not approve</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Ne pas approuver</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/review.py, the action approve]</extracomment>
   <translation>Approuver</translation>
  </message>
  <message>
   <source>Keep it locked</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Le laisser imposé</translation>
  </message>
  <message>
   <source>Unlock, and record it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Lever, et le consigner</translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Rester</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fermer et les perdre</translation>
  </message>
  <message>
   <source>Open a second annotator's folder (menu File) to compare the clicks of both.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Ouvrez le dossier d’un second annotateur (menu Fichier) pour comparer les clics des deux.</translation>
  </message>
  <message>
   <source>Apart: the two share (almost) no stretch of this element, which is no agreement. Was its class swapped with a neighbour's?</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>À part : les deux n’ont (presque) aucun tronçon commun de cet élément, ce qui n’est pas un accord. Sa classe a-t-elle été échangée avec celle d’un voisin ?</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks compared</source>
   <extracomment>{n:,} click compared / {n:,} clicks compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} clic comparé</numerusform>
    <numerusform>{n:,} clics comparés</numerusform>
   </translation>
  </message>
  <message>
   <source>{part} of {total}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{part} sur {total}</translation>
  </message>
  <message>
   <source>apart</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>à part</translation>
  </message>
  <message numerus="yes">
   <source>{compared}, {n} left out: beyond the ends of what the other clicked</source>
   <extracomment>{compared}, {n} left out: beyond the ends of what the other clicked / {compared}, {n} left out: beyond the ends of what the other clicked [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{compared}, {n} laissé de côté : au-delà des bouts de ce que l’autre a cliqué</numerusform>
    <numerusform>{compared}, {n} laissés de côté : au-delà des bouts de ce que l’autre a cliqué</numerusform>
   </translation>
  </message>
  <message>
   <source>Measuring the set…</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Mesure du jeu…</translation>
  </message>
  <message>
   <source>Distances by element</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Distances par élément</translation>
  </message>
  <message>
   <source>Close the second annotator</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Fermer le second annotateur</translation>
  </message>
  <message>
   <source>The second annotator's file for this frame is unreadable: {error}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Le fichier du second annotateur pour cette image est illisible : {error}</translation>
  </message>
  <message>
   <source>Agreement JaC at {tau:g} px: {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>JaC de l’accord à {tau:g} px : {jac:.3f}</translation>
  </message>
  <message>
   <source>No element is annotated by both in any frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Aucun élément n’est annoté par les deux sur une même image.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames unreadable, not compared</source>
   <extracomment>{n:,} frame unreadable, not compared / {n:,} frames unreadable, not compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} image illisible, non comparée</numerusform>
    <numerusform>{n:,} images illisibles, non comparées</numerusform>
   </translation>
  </message>
  <message>
   <source>Median</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Médiane</translation>
  </message>
  <message>
   <source>Points</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Points</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows the score once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Caché : le mode aveugle montre le score une fois cette image remise.</translation>
  </message>
  <message>
   <source>One of the two seems to label the field turned by 180 degrees.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>L’un des deux semble nommer le terrain tourné de 180 degrés.</translation>
  </message>
  <message>
   <source>Apart: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>À part : {elements}</translation>
  </message>
  <message>
   <source>Only here: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Seulement ici : {elements}</translation>
  </message>
  <message>
   <source>Only there: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Seulement là-bas : {elements}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks beyond the other's ends, left out</source>
   <extracomment>{n:,} click beyond the other's ends, left out / {n:,} clicks beyond the other's ends, left out [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} clic au-delà des bouts de l’autre, laissé de côté</numerusform>
    <numerusform>{n:,} clics au-delà des bouts de l’autre, laissés de côté</numerusform>
   </translation>
  </message>
  <message>
   <source>Nothing to measure noise by: all elements annotated by both are apart.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Rien pour mesurer le bruit : tous les éléments annotés par les deux sont à part.</translation>
  </message>
  <message numerus="yes">
   <source>Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height})</source>
   <extracomment>Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) / Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>Bruit humain sur {n:,} image : médiane {median:.2f} px, 95 % à moins de {p95:.2f} px (à {width}x{height})</numerusform>
    <numerusform>Bruit humain sur {n:,} images : médiane {median:.2f} px, 95 % à moins de {p95:.2f} px (à {width}x{height})</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>and {n} more</source>
   <extracomment>and {n} more / and {n} more [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>et {n} de plus</numerusform>
    <numerusform>et {n} de plus</numerusform>
   </translation>
  </message>
  <message>
   <source>The second annotator has nothing for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Le second annotateur n’a rien pour cette image.</translation>
  </message>
  <message>
   <source>Frames of this dataset that have a camera (completeness)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Images de ce jeu de données qui ont une caméra (complétude)</translation>
  </message>
  <message>
   <source>Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the fit was made from.
procc-annotator calibrate fits and scores the whole set</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Images visitées dans cette fenêtre dont les clics ont donné une caméra ; leur JaC est celui des clics qui ont servi à l’ajustement.
procc-annotator calibrate ajuste et note tout le jeu</translation>
  </message>
  <message>
   <source>Frames of this dataset that were followed through their shot and have a camera.
procc-annotator track follows a whole video and writes its cameras</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Images de ce jeu de données suivies à travers leur plan et qui ont une caméra.
procc-annotator track suit toute une vidéo et écrit ses caméras</translation>
  </message>
  <message>
   <source>Yellow</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Jaune</translation>
  </message>
  <message>
   <source>Violet</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Violet</translation>
  </message>
  <message>
   <source>Blue</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Bleu</translation>
  </message>
  <message>
   <source>Mint</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Menthe</translation>
  </message>
  <message>
   <source>Navy</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Bleu marine</translation>
  </message>
  <message>
   <source>Cyan</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Cyan</translation>
  </message>
  <message>
   <source>Switch the live fit off (Ctrl+T switches it on again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Désactiver l’ajustement continu (Ctrl+T le réactive)</translation>
  </message>
  <message>
   <source>Name of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Nom de la source</translation>
  </message>
  <message>
   <source>Draw as a wireframe while another source is judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Tracer en fil de fer pendant qu’une autre source est jugée</translation>
  </message>
  <message>
   <source>Mean JaC at {tau:.1f} px over {frames}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>JaC moyen à {tau:.1f} px sur {frames}</translation>
  </message>
  <message>
   <source>Unreadable (filter camera:unreadable): {names}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Illisibles (filtre camera:unreadable) : {names}</translation>
  </message>
  <message numerus="yes">
   <source>{matched} of {total}, {n} unreadable</source>
   <extracomment>{matched} of {total}, {n} unreadable / {matched} of {total}, {n} unreadable [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{matched} sur {total}, {n} illisible</numerusform>
    <numerusform>{matched} sur {total}, {n} illisibles</numerusform>
   </translation>
  </message>
  <message>
   <source>Remove from the list; the files stay</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Retirer de la liste ; les fichiers restent</translation>
  </message>
  <message>
   <source>Forget what was followed (T follows the shot again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Oublier ce qui a été suivi (T suit le plan à nouveau)</translation>
  </message>
  <message>
   <source>Judge nothing, draw no camera</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Ne rien juger, ne tracer aucune caméra</translation>
  </message>
  <message>
   <source>Judge against {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Juger {name}</translation>
  </message>
  <message>
   <source>Remove {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Retirer {name}</translation>
  </message>
  <message>
   <source>Draw {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Tracer {name}</translation>
  </message>
  <message>
   <source>Colour of {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Couleur de {name}</translation>
  </message>
  <message>
   <source>{frames} so far</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{frames} jusqu’ici</translation>
  </message>
  <message numerus="yes">
   <source>{mean}; {n:,} cameras cannot be read and take no part</source>
   <extracomment>{mean}; {n:,} camera cannot be read and takes no part / {mean}; {n:,} cameras cannot be read and take no part [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{mean} ; {n:,} caméra est illisible et ne participe pas</numerusform>
    <numerusform>{mean} ; {n:,} caméras sont illisibles et ne participent pas</numerusform>
   </translation>
  </message>
  <message>
   <source>{model} (ground)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} (sol)</translation>
  </message>
  <message>
   <source>{model} here</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} ici</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames followed</source>
   <extracomment>{n:,} frame followed / {n:,} frames followed [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} image suivie</numerusform>
    <numerusform>{n:,} images suivies</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} opened frames</source>
   <extracomment>{n:,} opened frame / {n:,} opened frames [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} image ouverte</numerusform>
    <numerusform>{n:,} images ouvertes</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ({share})</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{n} sur {total} ({share})</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n:,} more</source>
   <extracomment>{names} and {n:,} more / {names} and {n:,} more [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{names} et {n:,} de plus</numerusform>
    <numerusform>{names} et {n:,} de plus</numerusform>
   </translation>
  </message>
  <message>
   <source>cannot be used here: {error}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>inutilisable ici : {error}</translation>
  </message>
  <message>
   <source>no camera for this frame</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>pas de caméra pour cette image</translation>
  </message>
  <message>
   <source>Other…</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Autre…</translation>
  </message>
  <message>
   <source>Colour of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Couleur de la source</translation>
  </message>
  <message>
   <source>Double-click or F2 gives it another name</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Un double-clic ou F2 lui donne un autre nom</translation>
  </message>
  <message>
   <source>Blind mode hides how the sources do</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Le mode aveugle cache ce que valent les sources</translation>
  </message>
  <message>
   <source>No frame has both annotated elements and a camera of this source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Aucune image n’a à la fois des éléments annotés et une caméra de cette source</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} cameras</source>
   <extracomment>{n:,} camera / {n:,} cameras [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} caméra</numerusform>
    <numerusform>{n:,} caméras</numerusform>
   </translation>
  </message>
  <message>
   <source>none judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>n’en juger aucune</translation>
  </message>
  <message>
   <source>several models</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>plusieurs modèles</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the setting protocol]</extracomment>
   <translation>soccernet (officiel)</translation>
  </message>
  <message>
   <source>procc (paper)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>procc (article)</translation>
  </message>
  <message>
   <source>count as missed</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>compter comme manqués</translation>
  </message>
  <message>
   <source>are left out</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>sont laissés de côté</translation>
  </message>
  <message>
   <source>Cameras ({endings});;All files (*)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Caméras ({endings});;Tous les fichiers (*)</translation>
  </message>
  <message>
   <source>Source to compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Source à laquelle comparer</translation>
  </message>
  <message>
   <source>Compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Comparer à</translation>
  </message>
  <message>
   <source>{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>{share:.0f} % à moins de {far:g} m, sur {covered:.0f} % de l’image</translation>
  </message>
  <message>
   <source>No cameras loaded.
Load a folder of camera files or homographies to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Aucune caméra chargée.
Chargez un dossier de fichiers de caméra ou d’homographies pour les voir jugées d’après vos clics.</translation>
  </message>
  <message>
   <source>Load folder…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Charger un dossier…</translation>
  </message>
  <message>
   <source>Load file…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Charger un fichier…</translation>
  </message>
  <message>
   <source>Read as</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Lus comme</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the menus, the setting protocol]</extracomment>
   <translation>Protocole</translation>
  </message>
  <message>
   <source>Off the ground</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Hors du sol</translation>
  </message>
  <message>
   <source>This frame: {notice}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cette image : {notice}</translation>
  </message>
  <message>
   <source>⚠ This frame's camera cannot be used: {error}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>⚠ La caméra de cette image n’est pas utilisable : {error}</translation>
  </message>
  <message>
   <source>Held against the active source: comma, split view, disagreement</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Confrontée à la source active : virgule, vue partagée, désaccord</translation>
  </message>
  <message>
   <source>min</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>min</translation>
  </message>
  <message>
   <source>median</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>médiane</translation>
  </message>
  <message>
   <source>max</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>max</translation>
  </message>
  <message>
   <source>on the ground, m</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>au sol, m</translation>
  </message>
  <message>
   <source>in the picture, px</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>dans l’image, px</translation>
  </message>
  <message>
   <source>A folder with one camera file a frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Un dossier avec un fichier de caméra par image</translation>
  </message>
  <message>
   <source>A zip archive of cameras, or the camera of one frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Une archive zip de caméras, ou la caméra d’une image</translation>
  </message>
  <message>
   <source>How the files loaded next are read</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Comment seront lus les prochains fichiers chargés</translation>
  </message>
  <message>
   <source>soccernet: the official evaluation with its quirks
procc: the paper's definition, closed circles and fine curves</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>soccernet : l’évaluation officielle avec ses bizarreries
procc : la définition de l’article, cercles fermés et courbes fines</translation>
  </message>
  <message>
   <source>A homography knows the ground only: how posts and crossbars count for it</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Une homographie ne connaît que le sol : comment comptent pour elle poteaux et barres</translation>
  </message>
  <message>
   <source>Between the two points on the ground that a pixel means</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Entre les deux points du sol que désigne un pixel</translation>
  </message>
  <message>
   <source>From a pixel to where the compared camera shows its ground point</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>D’un pixel à l’endroit où la caméra comparée montre son point du sol</translation>
  </message>
  <message>
   <source>annotated</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py, procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>annoté</translation>
  </message>
  <message>
   <source>unconfirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>non confirmé</translation>
  </message>
  <message>
   <source>not visible</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>pas visible</translation>
  </message>
  <message>
   <source>next</source>
   <comment>element</comment>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>suivant</translation>
  </message>
  <message>
   <source>Not annotated in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Non annoté sur cette image</translation>
  </message>
  <message>
   <source>Annotated, but not judged: no camera is shown, or it takes no part in the evaluation</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Annoté, mais non jugé : aucune caméra n’est montrée, ou il ne participe pas à l’évaluation</translation>
  </message>
  <message>
   <source>Copied; it does not count until it is touched or confirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Copié ; il ne compte pas avant d’être touché ou confirmé</translation>
  </message>
  <message>
   <source>Passes: all its points are closer than tau to the projection</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Passe : tous ses points sont plus proches de la projection que tau</translation>
  </message>
  <message>
   <source>Too far: at least one point is tau or more away (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Trop loin : au moins un point est à tau ou plus (faux positif)</translation>
  </message>
  <message>
   <source>The camera projects it, it is not annotated (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>La caméra le projette, il n’est pas annoté (faux positif)</translation>
  </message>
  <message>
   <source>Annotated, the camera does not project it (false negative)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Annoté, la caméra ne le projette pas (faux négatif)</translation>
  </message>
  <message>
   <source>Marked as not visible in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Quelqu’un a dit qu’il ne se voit pas sur cette image</translation>
  </message>
  <message>
   <source>To be annotated next, as on the field map and in the picture</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>À annoter ensuite, comme sur le plan du terrain et dans l’image</translation>
  </message>
  <message>
   <source>{title} (unknown class)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>{title} (classe inconnue)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Sans géométrie</translation>
  </message>
  <message>
   <source>Unknown to the field (unknown classes)</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Inconnues du terrain (classes inconnues)</translation>
  </message>
  <message>
   <source>Find an element</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Trouver un élément</translation>
  </message>
  <message>
   <source>No element matches “{query}”.
Esc clears the search.</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Aucun élément ne correspond à « {query} ».
Échap efface la recherche.</translation>
  </message>
  <message>
   <source>Annotated points</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Points annotés</translation>
  </message>
  <message>
   <source>{title}
Class in files: {name}</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>{title}
Classe dans les fichiers : {name}</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Éléments</translation>
  </message>
  <message>
   <source>Key</source>
   <comment>keyboard</comment>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Touche</translation>
  </message>
  <message>
   <source>Pts</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Pts</translation>
  </message>
  <message>
   <source>Status</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>État</translation>
  </message>
  <message>
   <source>Annotating it next helps most: the projection is then known to {after:.1f} px instead of {before:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>L’annoter ensuite apporte le plus : la projection sera connue à {after:.1f} px au lieu de {before:.1f} px</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Plan du terrain</translation>
  </message>
  <message>
   <source>The arrows choose elements</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Les flèches choisissent les éléments</translation>
  </message>
  <message>
   <source>far</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>loin</translation>
  </message>
  <message>
   <source>right</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>droite</translation>
  </message>
  <message>
   <source>near</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>près</translation>
  </message>
  <message>
   <source>left</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>gauche</translation>
  </message>
  <message>
   <source>Next: {title}, {before:.1f} → {after:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Suivant : {title}, {before:.1f} → {after:.1f} px</translation>
  </message>
  <message>
   <source>Click an element</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Cliquez un élément</translation>
  </message>
  <message>
   <source>{shown:,} of {frames}</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>{shown:,} sur {frames}</translation>
  </message>
  <message>
   <source>Show all frames</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py]</extracomment>
   <translation>Afficher toutes les images</translation>
  </message>
  <message>
   <source>Error</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Erreur</translation>
  </message>
  <message>
   <source>Warning</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Avertissement</translation>
  </message>
  <message>
   <source>Hint</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Remarque</translation>
  </message>
  <message>
   <source>Nothing found in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Rien trouvé sur cette image.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found in {n:,} frames.</source>
   <extracomment>Nothing found in {n:,} frame. / Nothing found in {n:,} frames. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Rien trouvé sur {n:,} image.</numerusform>
    <numerusform>Rien trouvé sur {n:,} images.</numerusform>
   </translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures to check their labels.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Aucune image.
Ouvrez un dossier d’images pour en vérifier les classes.</translation>
  </message>
  <message>
   <source>Nothing is annotated in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Rien n’est annoté sur cette image.</translation>
  </message>
  <message>
   <source>No problems so far.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Aucun problème jusqu’ici.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found but {n:,} ignored findings.</source>
   <extracomment>Nothing found but {n:,} ignored finding. / Nothing found but {n:,} ignored findings. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Rien trouvé hormis {n:,} constat ignoré.</numerusform>
    <numerusform>Rien trouvé hormis {n:,} constats ignorés.</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Aveugle : les constats qui demandent une caméra attendent la remise de cette image (Ctrl+Entrée).</translation>
  </message>
  <message>
   <source>The live fit is off: the full check needs it.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>L’ajustement continu est désactivé : la vérification complète en a besoin.</translation>
  </message>
  <message>
   <source>Full check needs a camera: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>La vérification complète demande une caméra : {why}.</translation>
  </message>
  <message>
   <source>Blind: only committed frames are checked with a camera.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Aveugle : seules les images remises sont vérifiées avec une caméra.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked, such as {name}: {why}</source>
   <extracomment>{n:,} frame cannot be checked, such as {name}: {why} / {n:,} frames cannot be checked, such as {name}: {why} [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} image ne peut être vérifiée, comme {name} : {why}</numerusform>
    <numerusform>{n:,} images ne peuvent être vérifiées, comme {name} : {why}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>The set is not checked yet; {n:,} frames checked so far.</source>
   <extracomment>The set is not checked yet; {n:,} frame checked so far. / The set is not checked yet; {n:,} frames checked so far. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Le jeu n’est pas encore vérifié ; {n:,} image regardée jusqu’ici.</numerusform>
    <numerusform>Le jeu n’est pas encore vérifié ; {n:,} images regardées jusqu’ici.</numerusform>
   </translation>
  </message>
  <message>
   <source>List the findings of all checked frames, errors first, or of this frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Lister les constats de toutes les images vérifiées, erreurs d’abord, ou ceux de cette image</translation>
  </message>
  <message>
   <source>Frames checked</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Images vérifiées</translation>
  </message>
  <message>
   <source>Checking this frame…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Vérification de cette image…</translation>
  </message>
  <message>
   <source>Checking the set…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Vérification du jeu…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} errors</source>
   <extracomment>{n:,} error / {n:,} errors [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} erreur</numerusform>
    <numerusform>{n:,} erreurs</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} warnings</source>
   <extracomment>{n:,} warning / {n:,} warnings [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} avertissement</numerusform>
    <numerusform>{n:,} avertissements</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} hints</source>
   <extracomment>{n:,} hint / {n:,} hints [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} remarque</numerusform>
    <numerusform>{n:,} remarques</numerusform>
   </translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>Vérifier tout le jeu</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} more are not listed: switch the signs above on.</source>
   <extracomment>{n:,} more is not listed: switch the signs above on. / {n:,} more are not listed: switch the signs above on. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} de plus n’est pas listé : activez les signes ci-dessus.</numerusform>
    <numerusform>{n:,} de plus ne sont pas listés : activez les signes ci-dessus.</numerusform>
   </translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action ignore_finding]</extracomment>
   <translation>Ne plus le montrer tant que les points de ses éléments ne changent pas</translation>
  </message>
  <message>
   <source>Findings</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Constats</translation>
  </message>
  <message>
   <source>Whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Tout le jeu</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>Chercher les mauvaises classes dans toutes les images annotées</translation>
  </message>
  <message>
   <source>Write the findings of all checked frames as CSV</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Écrire en CSV les constats de toutes les images vérifiées</translation>
  </message>
  <message>
   <source>{findings}; click to list them or not</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>{findings} ; cliquer pour les lister ou non</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt;</source>
   <extracomment>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; / {n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} ignoré ici. &lt;a href="restore"&gt;Réafficher&lt;/a&gt;</numerusform>
    <numerusform>{n:,} ignorés ici. &lt;a href="restore"&gt;Réafficher&lt;/a&gt;</numerusform>
   </translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/menus.py, the action ignore_finding]</extracomment>
   <translation>Ignorer ce constat</translation>
  </message>
  <message>
   <source>Mean</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Moyenne</translation>
  </message>
  <message>
   <source>Largest</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Plus grand</translation>
  </message>
  <message>
   <source>Worst first; a click shows the worst point</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Les pires d’abord ; un clic montre le pire point</translation>
  </message>
  <message>
   <source>Mean distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distance moyenne de ses points à l’élément ajusté, px de l’image</translation>
  </message>
  <message>
   <source>Largest distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Plus grande distance de ses points à l’élément ajusté, px de l’image</translation>
  </message>
  <message>
   <source>{model}. Chosen: {why}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{model}. Choisi : {why}</translation>
  </message>
  <message numerus="yes">
   <source>{passing} of {n:,} annotated elements within {px:g} px</source>
   <extracomment>{passing} of {n:,} annotated element within {px:g} px / {passing} of {n:,} annotated elements within {px:g} px [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{passing} sur {n:,} élément annoté à moins de {px:g} px</numerusform>
    <numerusform>{passing} sur {n:,} éléments annotés à moins de {px:g} px</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{counted}; {n} in sight not annotated yet</source>
   <extracomment>{counted}; {n} in sight not annotated yet / {counted}; {n} in sight not annotated yet [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{counted} ; {n} en vue pas encore annoté</numerusform>
    <numerusform>{counted} ; {n} en vue pas encore annotés</numerusform>
   </translation>
  </message>
  <message>
   <source>{title}: mean {mean} px, largest {largest} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{title} : moyenne {mean} px, plus grand {largest} px</translation>
  </message>
  <message>
   <source>Taken for a mistake: it had no say in the fit</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Pris pour une erreur : n’a pas compté dans l’ajustement</translation>
  </message>
  <message>
   <source>Elements in sight that are not annotated count against the JaC</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Les éléments en vue non annotés comptent contre le JaC</translation>
  </message>
  <message>
   <source>Hardly determined: {limits}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>À peine déterminé : {limits}</translation>
  </message>
  <message>
   <source>Mean distance of the points that had a say, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distance moyenne des points qui ont compté, px de l’image</translation>
  </message>
  <message>
   <source>Standard deviation, as the fit estimates it</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Écart type, tel que l’ajustement l’estime</translation>
  </message>
  <message>
   <source>Save as the frame's camera</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Enregistrer comme caméra de l’image</translation>
  </message>
  <message>
   <source>✕ left out: {title}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>✕ laissé de côté : {title}</translation>
  </message>
  <message>
   <source>Pan</source>
   <comment>an angle</comment>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Panoramique</translation>
  </message>
  <message>
   <source>Tilt</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Inclinaison</translation>
  </message>
  <message>
   <source>Roll</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Roulis</translation>
  </message>
  <message>
   <source>Focal length</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distance focale</translation>
  </message>
  <message>
   <source>Along (x)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>En long (x)</translation>
  </message>
  <message>
   <source>Across (y)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>En large (y)</translation>
  </message>
  <message>
   <source>Height (−z)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Hauteur (−z)</translation>
  </message>
  <message>
   <source>Model</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Modèle</translation>
  </message>
  <message>
   <source>Residuals by element</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Résidus par élément</translation>
  </message>
  <message>
   <source>No camera yet: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Pas encore de caméra : {why}.</translation>
  </message>
  <message>
   <source>Fitting the clicks…</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Ajustement des clics…</translation>
  </message>
  <message>
   <source>No fit.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Pas d’ajustement.</translation>
  </message>
  <message>
   <source>JaC at {tau:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py, procc_annotator/gui/panels/plots/pages.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC à {tau:.1f} px</translation>
  </message>
  <message>
   <source>&lt;b&gt;Hardly determined&lt;/b&gt;: {what}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>&lt;b&gt;À peine déterminé&lt;/b&gt; : {what}</translation>
  </message>
  <message>
   <source>JaC: {terms}; residuals: px of the picture, {width}x{height}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>JaC : {terms} ; résidus : px de l’image, {width}x{height}</translation>
  </message>
  <message>
   <source>What is fitted. Automatically: the simplest model that the clicks support</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Ce qui est ajusté. Automatiquement : le modèle le plus simple que permettent les clics</translation>
  </message>
  <message>
   <source>mean residual</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>résidu moyen</translation>
  </message>
  <message numerus="yes">
   <source>{n} open</source>
   <extracomment>{n} open / {n} open [procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n} ouvert</numerusform>
    <numerusform>{n} ouverts</numerusform>
   </translation>
  </message>
  <message>
   <source>all done</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>toutes terminées</translation>
  </message>
  <message>
   <source>not annotated</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>non annotée</translation>
  </message>
  <message>
   <source>⚠ unreadable</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ illisible</translation>
  </message>
  <message>
   <source>⚠ camera</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ caméra</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} done</source>
   <extracomment>{n:,} done / {n:,} done [procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>
    <numerusform>{n:,} terminée</numerusform>
    <numerusform>{n:,} terminées</numerusform>
   </translation>
  </message>
  <message>
   <source>● not saved</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>● non enregistrée</translation>
  </message>
  <message>
   <source>the picture cannot be read</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>l’image est illisible</translation>
  </message>
  <message>
   <source>mean JaC {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>JaC moyen {jac:.3f}</translation>
  </message>
  <message>
   <source>folded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>replié</translation>
  </message>
  <message>
   <source>unfolded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>déplié</translation>
  </message>
  <message>
   <source>Filter frames</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Filtrer les images</translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures (jpg, png, bmp, webp), or drop one here.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Aucune image.
Ouvrez un dossier d’images (jpg, png, bmp, webp), ou déposez-en un ici.</translation>
  </message>
  <message>
   <source>Nothing matches “{query}”.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Rien ne correspond à « {query} ».</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} folders</source>
   <extracomment>{frames} in {n:,} folder / {frames} in {n:,} folders [procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>
    <numerusform>{frames} dans {n:,} dossier</numerusform>
    <numerusform>{frames} dans {n:,} dossiers</numerusform>
   </translation>
  </message>
  <message>
   <source>No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the corner of a board, a floodlight. Name one below, and click it in two calibrated views.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Aucun repère. Un repère est un lieu de ce stade que le terrain n’a pas : un siège, le coin d’un panneau, un projecteur. Nommez-en un ci-dessous, et cliquez-le dans deux vues calibrées.</translation>
  </message>
  <message>
   <source>Find its place from the views it is clicked in; cameras are those of the active source, else fits to the clicks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Trouver son lieu d’après les vues où il est cliqué ; les caméras sont celles de la source active, sinon des ajustements aux clics</translation>
  </message>
  <message>
   <source>Other views of this instant</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Autres vues de cet instant</translation>
  </message>
  <message>
   <source>No other views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Pas d’autres vues</translation>
  </message>
  <message>
   <source>Its place cannot be brought back with undo. Clicks on it stay in the annotations.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Annuler ne ramène pas son lieu. Les clics restent dans les annotations.</translation>
  </message>
  <message>
   <source>Landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Repère</translation>
  </message>
  <message>
   <source>Views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Vues</translation>
  </message>
  <message>
   <source>Triangulated from {frames}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangulé d’après {frames}</translation>
  </message>
  <message>
   <source>Other views of this instant: go to one with a click</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Autres vues de cet instant : y aller d’un clic</translation>
  </message>
  <message>
   <source>{title} is clicked in no frame yet: click it in two calibrated views to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} n’est encore cliqué sur aucune image : cliquez-le dans deux vues calibrées pour qu’il soit triangulé.</translation>
  </message>
  <message>
   <source>Clicked here, but no landmarks yet: {names}. Write a name next to Add to triangulate it.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Cliqués ici, mais pas encore des repères : {names}. Écrivez un nom à côté d’Ajouter pour les trianguler.</translation>
  </message>
  <message>
   <source>Its place is not known yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Son lieu n’est pas encore connu</translation>
  </message>
  <message>
   <source>Surveyed</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Mesuré sur place</translation>
  </message>
  <message>
   <source>New landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Nouveau repère</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/panels/review.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Ajouter</translation>
  </message>
  <message>
   <source>What people call it</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Comment on l’appelle</translation>
  </message>
  <message>
   <source>x, y, z in metres, z down</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>x, y, z en mètres, z vers le bas</translation>
  </message>
  <message>
   <source>Set</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Fixer</translation>
  </message>
  <message>
   <source>Triangulate</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Trianguler</translation>
  </message>
  <message>
   <source>Standard deviation in the direction where it is largest</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Écart type dans la direction où il est le plus grand</translation>
  </message>
  <message>
   <source>{name} is being triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{name} est en cours de triangulation.</translation>
  </message>
  <message>
   <source>{why}. Delete the landmark and name it again to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{why}. Supprimez le repère et nommez-le à nouveau pour qu’il soit triangulé.</translation>
  </message>
  <message>
   <source>Looking for the frames in which {title} is clicked…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Recherche des images où {title} est cliqué…</translation>
  </message>
  <message>
   <source>{title} is clicked in {frame} alone: click it in another calibrated view to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} n’est cliqué que sur {frame} : cliquez-le dans une autre vue calibrée pour qu’il soit triangulé.</translation>
  </message>
  <message>
   <source>Choose a landmark in the list to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Choisissez un repère dans la liste pour le trianguler.</translation>
  </message>
  <message>
   <source>Only a landmark that has a name can be triangulated: write one next to Add.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Seul un repère qui a un nom peut être triangulé : écrivez-en un à côté d’Ajouter.</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n} more</source>
   <extracomment>{names} and {n} more / {names} and {n} more [procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>
    <numerusform>{names} et {n} de plus</numerusform>
    <numerusform>{names} et {n} de plus</numerusform>
   </translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Repères</translation>
  </message>
  <message>
   <source>Have a new landmark, to be clicked (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Créer un nouveau repère, à cliquer (Entrée)</translation>
  </message>
  <message>
   <source>The place was measured: it stays as it is from now on (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Le lieu a été mesuré : il reste désormais ce qu’il est (Entrée)</translation>
  </message>
  <message>
   <source>Forget this landmark; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Oublier ce repère ; les clics restent dans les annotations</translation>
  </message>
  <message>
   <source>Title</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Titre</translation>
  </message>
  <message>
   <source>Place</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Lieu</translation>
  </message>
  <message>
   <source>Not clicked in any frame yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Encore cliqué sur aucune image</translation>
  </message>
  <message>
   <source>Triangulating…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangulation…</translation>
  </message>
  <message>
   <source>a landmark needs a name: write one next to Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>un repère a besoin d’un nom : écrivez-en un à côté d’Ajouter</translation>
  </message>
  <message>
   <source>deleted the landmark {title}; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>repère {title} supprimé ; les clics restent dans les annotations</translation>
  </message>
  <message>
   <source>the landmark {title}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>le repère {title}</translation>
  </message>
  <message>
   <source>Picture (*.png);;Vector graphics (*.svg)</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Image (*.png);;Image vectorielle (*.svg)</translation>
  </message>
  <message>
   <source>the plotted numbers are on the clipboard</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>les nombres du graphique sont dans le presse-papiers</translation>
  </message>
  <message>
   <source>Save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Enregistrer le graphique</translation>
  </message>
  <message>
   <source>wrote {path}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} écrit, pour ce qui est noté</translation>
  </message>
  <message>
   <source>wrote {path}</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} écrit</translation>
  </message>
  <message>
   <source>the plot is on the clipboard as a picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>le graphique est dans le presse-papiers comme image</translation>
  </message>
  <message>
   <source>there is nothing plotted to take along</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>il n’y a rien de tracé à emporter</translation>
  </message>
  <message>
   <source>{frames}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{frames}, pour ce qui est noté</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows committed frames only, and none of them is in this plot.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Caché : le mode aveugle ne montre que les images remises, et aucune n’est dans ce graphique.</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows this plot once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Caché : le mode aveugle montre ce graphique une fois cette image remise.</translation>
  </message>
  <message>
   <source>Sources: {names}</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Sources : {names}</translation>
  </message>
  <message>
   <source>Shots are recognized by names, since {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Les plans sont reconnus d’après les noms, car {error}.</translation>
  </message>
  <message>
   <source>JaC over tau</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC selon tau</translation>
  </message>
  <message>
   <source>JaC over the frames</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC selon les images</translation>
  </message>
  <message>
   <source>No scores yet. They are computed in the background, frame by frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pas encore de scores. Ils sont calculés en arrière-plan, image par image.</translation>
  </message>
  <message>
   <source>Errors, as a histogram</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Erreurs, en histogramme</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points without a distance left out.</source>
   <extracomment>{n:,} point without a distance left out. / {n:,} points without a distance left out. [procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>
    <numerusform>{n:,} point sans distance laissé de côté.</numerusform>
    <numerusform>{n:,} points sans distance laissés de côté.</numerusform>
   </translation>
  </message>
  <message>
   <source>Residuals over the picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Résidus sur l’image</translation>
  </message>
  <message>
   <source>tau (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau (px)</translation>
  </message>
  <message>
   <source>frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>image</translation>
  </message>
  <message>
   <source>{name} (frame {n})</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} (image {n})</translation>
  </message>
  <message>
   <source>No score of this frame: it is not annotated, or no shown source has its camera.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pas de score de cette image : elle n’est pas annotée, ou aucune source affichée n’a sa caméra.</translation>
  </message>
  <message>
   <source>reprojection error (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>erreur de reprojection (px)</translation>
  </message>
  <message>
   <source>points</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>points</translation>
  </message>
  <message>
   <source>How many times longer than they are arrows are drawn</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Combien de fois plus longues qu’en vérité les flèches sont tracées</translation>
  </message>
  <message>
   <source>Arrows drawn longer</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flèches allongées</translation>
  </message>
  <message>
   <source>The last bar holds all larger errors.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>La dernière barre réunit toutes les erreurs plus grandes.</translation>
  </message>
  <message>
   <source>{px:g} px or more</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{px:g} px ou plus</translation>
  </message>
  <message>
   <source>{name} {part:,} of {total:,}</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} {part:,} sur {total:,}</translation>
  </message>
  <message>
   <source>No point of {element} in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aucun point de {element} sur cette image.</translation>
  </message>
  <message>
   <source>No point of {element} so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aucun point de {element} jusqu’ici.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aucun point annoté de cette image n’est projeté par une source affichée.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aucun point annoté n’est encore projeté par une source affichée.</translation>
  </message>
  <message>
   <source>automatic</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>automatique</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: from the click towards the projection.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flèches {factor} fois plus longues qu’en vérité : du clic vers la projection.</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: the median residual of each part of the picture with 5 points or more.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flèches {factor} fois plus longues qu’en vérité : le résidu médian de chaque partie de l’image qui a 5 points ou plus.</translation>
  </message>
  <message>
   <source>Each curve is the mean of the frames that source has a camera for.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Chaque courbe est la moyenne des images pour lesquelles cette source a une caméra.</translation>
  </message>
  <message>
   <source>Shaded: 95 % bands, {drawn}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Ombré : bandes à 95 %, {drawn}.</translation>
  </message>
  <message>
   <source>tau {px:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau {px:.1f} px</translation>
  </message>
  <message>
   <source>Too few points so far: five in a part of the picture make an arrow.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Trop peu de points pour l’instant : cinq dans une partie de l’image font une flèche.</translation>
  </message>
  <message>
   <source>This frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Cette image</translation>
  </message>
  <message>
   <source>Copy or save the plot and its numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copier ou enregistrer le graphique et ses nombres</translation>
  </message>
  <message>
   <source>Plot the points of one element only</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Tracer les points d’un seul élément</translation>
  </message>
  <message>
   <source>({n:,} of {total:,})</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} sur {total:,})</translation>
  </message>
  <message>
   <source>All elements</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Tous les éléments</translation>
  </message>
  <message>
   <source>Plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Graphique</translation>
  </message>
  <message>
   <source>This plot could not be computed: {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Ce graphique n’a pu être calculé : {error}.</translation>
  </message>
  <message>
   <source>({n:,} committed)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} remises)</translation>
  </message>
  <message>
   <source>Copy or save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copier ou enregistrer le graphique</translation>
  </message>
  <message>
   <source>Copy picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copier l’image</translation>
  </message>
  <message>
   <source>Copy numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copier les nombres</translation>
  </message>
  <message>
   <source>Save picture…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Enregistrer l’image…</translation>
  </message>
  <message>
   <source>Save numbers…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Enregistrer les nombres…</translation>
  </message>
  <message>
   <source>Plot the frame on screen, or all frames scored so far</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Tracer l’image à l’écran, ou toutes celles notées jusqu’ici</translation>
  </message>
  <message>
   <source>Computing…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Calcul…</translation>
  </message>
  <message>
   <source>(hidden)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(caché)</translation>
  </message>
  <message>
   <source>(no score)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(sans score)</translation>
  </message>
  <message>
   <source>Save</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Garder</translation>
  </message>
  <message>
   <source>Committed in blind mode, and as it was then.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Remise en mode aveugle, et restée telle quelle.</translation>
  </message>
  <message>
   <source>Edited after the cameras were shown.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Modifiée après que les caméras ont été montrées.</translation>
  </message>
  <message>
   <source>{seconds} s</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{seconds} s</translation>
  </message>
  <message>
   <source>How the points of this frame came to be</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Comment les points de cette image sont nés</translation>
  </message>
  <message>
   <source>Add the comment to the thread (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Ajouter le commentaire à la discussion (Entrée)</translation>
  </message>
  <message>
   <source>Committed in blind mode by {author}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Remise en mode aveugle par {author}</translation>
  </message>
  <message>
   <source>{minutes}:{seconds:02d} min</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{minutes}:{seconds:02d} min</translation>
  </message>
  <message>
   <source>This frame is right (Ctrl+Shift+A)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Cette image est correcte (Ctrl+Maj+A)</translation>
  </message>
  <message>
   <source>Send it back (Ctrl+Shift+X)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>La renvoyer (Ctrl+Maj+X)</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[procc_annotator/gui/panels/review.py, the action reject]</extracomment>
   <translation>Rejeter</translation>
  </message>
  <message>
   <source>No comments on this frame.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Aucun commentaire sur cette image.</translation>
  </message>
  <message>
   <source>Comment on this place</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Commentaire sur cet endroit</translation>
  </message>
  <message>
   <source>{frame} is {status}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{frame} est {status}</translation>
  </message>
  <message>
   <source>{frame} is {status} again</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} est de nouveau {status}</translation>
  </message>
  <message>
   <source>Time worked on this frame; pauses over 30 s do not count</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Temps passé sur cette image ; les pauses de plus de 30 s ne comptent pas</translation>
  </message>
  <message>
   <source>Comments</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Commentaires</translation>
  </message>
  <message>
   <source>Points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Points : {kinds}</translation>
  </message>
  <message>
   <source>Points: none</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Points : aucun</translation>
  </message>
  <message numerus="yes">
   <source>to be confirmed (Shift+V): {n:,} elements</source>
   <extracomment>to be confirmed (Shift+V): {n:,} element / to be confirmed (Shift+V): {n:,} elements [procc_annotator/gui/panels/review.py]</extracomment>
   <translation>
    <numerusform>à confirmer (Maj+V) : {n:,} élément</numerusform>
    <numerusform>à confirmer (Maj+V) : {n:,} éléments</numerusform>
   </translation>
  </message>
  <message>
   <source>Comment on this frame</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Commentaire sur cette image</translation>
  </message>
  <message>
   <source>Ticked: settled</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Coché : réglé</translation>
  </message>
  <message>
   <source>somebody</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/editing/batch_edits.py, procc_annotator/gui/state/state.py]</extracomment>
   <translation>quelqu’un</translation>
  </message>
  <message>
   <source>Choose an element to read why it counts as it does.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Choisissez un élément pour lire pourquoi il compte ainsi.</translation>
  </message>
  <message>
   <source>the camera is the fit to these same clicks: this JaC is no score of a method</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>la caméra est l’ajustement à ces mêmes clics : ce JaC n’est le score d’aucune méthode</translation>
  </message>
  <message>
   <source>Mirrored labels count here: the field turned by 180° fits at least as well.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Les classes en miroir comptent ici : le terrain tourné de 180° convient au moins aussi bien.</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>bruit humain {median:.2f} px, 95 % à moins de {p95:.2f} px</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>bruit humain {median:.2f} px, 95 % à moins de {p95:.2f} px – plus que tau</translation>
  </message>
  <message>
   <source>Point</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Point</translation>
  </message>
  <message>
   <source>Worst</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Pire</translation>
  </message>
  <message>
   <source>Passes at</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Passe à</translation>
  </message>
  <message>
   <source>Click a row to see the point that decides</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Cliquez une ligne pour voir le point qui décide</translation>
  </message>
  <message>
   <source>How the element counts at tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Comment l’élément compte à tau</translation>
  </message>
  <message>
   <source>The point that decides, counted from 1</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Le point qui décide, compté à partir de 1</translation>
  </message>
  <message>
   <source>Largest distance of its points to the projection, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Plus grande distance de ses points à la projection, px</translation>
  </message>
  <message>
   <source>The smallest tau of the slider at which it passes, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Le plus petit tau du curseur auquel il passe, px</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Caméra fausse</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Annotation fausse</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>La caméra active est fausse sur cette image</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Les clics sont faux sur cette image</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Caméra et clics sont justes sur cette image</translation>
  </message>
  <message>
   <source>What causes the score of this frame; saved with the dataset</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>À qui la faute du score de cette image ; conservé avec le jeu de données</translation>
  </message>
  <message>
   <source>Precision</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Précision</translation>
  </message>
  <message>
   <source>Recall</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Rappel</translation>
  </message>
  <message>
   <source>Mean error</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Erreur moyenne</translation>
  </message>
  <message>
   <source>Mean reprojection error of all points, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Erreur de reprojection moyenne de tous les points, px</translation>
  </message>
  <message>
   <source>Median reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Erreur de reprojection médiane, px</translation>
  </message>
  <message>
   <source>Max</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Max.</translation>
  </message>
  <message>
   <source>Largest reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Plus grande erreur de reprojection, px</translation>
  </message>
  <message>
   <source>{name} has no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{name} n’a pas de caméra pour cette image.</translation>
  </message>
  <message>
   <source>points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>points : {kinds}</translation>
  </message>
  <message>
   <source>{verdict}; once more takes it back ({key})</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{verdict} ; une fois de plus le retire ({key})</translation>
  </message>
  <message>
   <source>Verdict: {verdict}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Verdict : {verdict}</translation>
  </message>
  <message>
   <source>Scores by element</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Scores par élément</translation>
  </message>
  <message>
   <source>Copy this explanation</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Copier cette explication</translation>
  </message>
  <message>
   <source>Copy all explanations</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Copier toutes les explications</translation>
  </message>
  <message>
   <source>JaC –: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC – : {why}.</translation>
  </message>
  <message>
   <source>This frame's camera cannot be used:
{error}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>La caméra de cette image n’est pas utilisable :
{error}</translation>
  </message>
  <message>
   <source>No fit to judge: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Aucun ajustement à juger : {why}.</translation>
  </message>
  <message>
   <source>Counts as {class_name}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Compte comme {class_name}</translation>
  </message>
  <message>
   <source>Verdict</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Verdict</translation>
  </message>
  <message>
   <source>Elements whose points all are closer than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Éléments dont tous les points sont plus proches que tau</translation>
  </message>
  <message>
   <source>Elements too far, or projected and not annotated</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Éléments trop loin, ou projetés et non annotés</translation>
  </message>
  <message>
   <source>Annotated elements that the camera does not project</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Éléments annotés que la caméra ne projette pas</translation>
  </message>
  <message>
   <source>anchor</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ancre</translation>
  </message>
  <message>
   <source>followed</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>suivie</translation>
  </message>
  <message>
   <source>bridged</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>comblée</translation>
  </message>
  <message>
   <source>lost</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>perdue</translation>
  </message>
  <message>
   <source>frame {number} of {first}–{last}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>image {number} de {first}–{last}</translation>
  </message>
  <message>
   <source>{state}, {share:.0%} of the lines on paint</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{state}, {share:.0%} des lignes sur de la peinture</translation>
  </message>
  <message>
   <source>names count by {step}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>les noms comptent de {step} en {step}</translation>
  </message>
  <message>
   <source>its camera was dragged</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>sa caméra a été glissée</translation>
  </message>
  <message>
   <source>blind: its camera is hidden</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>aveugle : sa caméra est cachée</translation>
  </message>
  <message>
   <source>{found}, {far:.1f} px from it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{found}, à {far:.1f} px</translation>
  </message>
  <message>
   <source>doubtful: {why}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>douteuse : {why}</translation>
  </message>
  <message>
   <source>Frames of the shot</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Images du plan</translation>
  </message>
  <message>
   <source>The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Les flèches vont d’image en image, avec Maj elles marquent un passage, Échap l’oublie</translation>
  </message>
  <message>
   <source>not {number:g}: {least:g} to {most:g}{unit}</source>
   <extracomment>[procc_annotator/gui/panels/widgets.py]</extracomment>
   <translation>pas {number:g} : de {least:g} à {most:g}{unit}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Ajustement et fantômes</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Annotation</translation>
  </message>
  <message>
   <source>blind: the camera is hidden until this frame is committed (Ctrl+Enter)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>aveugle : la caméra est cachée jusqu’à la remise de cette image (Ctrl+Entrée)</translation>
  </message>
  <message>
   <source>load cameras first: there is nothing to score</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>chargez d’abord des caméras : il n’y a rien à noter</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>ouvrez d’abord un dossier d’images</translation>
  </message>
  <message>
   <source>choose the camera to judge first (C)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>choisissez d’abord la caméra à juger (C)</translation>
  </message>
  <message>
   <source>the live fit is off (Ctrl+T)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>l’ajustement continu est désactivé (Ctrl+T)</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>unexpected error ({what})</source>
   <extracomment>[procc_annotator/gui/state/background.py]</extracomment>
   <translation>erreur inattendue ({what})</translation>
  </message>
  <message>
   <source>expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>fichiers attendus comme camera_00037.json, 00037.npy ou 00037.homographyMatrix</translation>
  </message>
  <message>
   <source>load one of its folders: {names}</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>chargez un de ses dossiers : {names}</translation>
  </message>
  <message>
   <source>it holds the same already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>elle contient déjà la même chose</translation>
  </message>
  <message>
   <source>it is annotated already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>elle est déjà annotée</translation>
  </message>
  <message>
   <source>{who} is editing it</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>{who} la modifie</translation>
  </message>
  <message>
   <source>it cannot be edited</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>elle ne peut être modifiée</translation>
  </message>
  <message>
   <source>blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked after that is no blind work</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>aveugle : rien n’est annoté ici ; Ctrl+Entrée encore montre les caméras, et ce qui est cliqué ensuite n’est plus du travail à l’aveugle</translation>
  </message>
  <message>
   <source>{frame} is done</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} est terminée</translation>
  </message>
  <message>
   <source>nothing to undo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rien à annuler sur cette image</translation>
  </message>
  <message>
   <source>undo once more takes that away</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>annuler encore l’enlève</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere and read again: {so}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} a été changée ailleurs et relue : {so}</translation>
  </message>
  <message>
   <source>unconfirmed elements do not count: {count}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>les éléments non confirmés ne comptent pas : {count}</translation>
  </message>
  <message>
   <source>undone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>annulé : {step}</translation>
  </message>
  <message>
   <source>redone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rétabli : {step}</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} a été changée ailleurs : relue</translation>
  </message>
  <message>
   <source>nothing is undone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rien n’est annulé</translation>
  </message>
  <message>
   <source>nothing is redone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rien n’est rétabli</translation>
  </message>
  <message>
   <source>nothing to redo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rien à rétablir sur cette image</translation>
  </message>
  <message>
   <source>cameras of {name} changed: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>les caméras de {name} ont changé : {why}</translation>
  </message>
  <message>
   <source>cameras of {name} changed on disk: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>les caméras de {name} ont changé sur le disque : relues</translation>
  </message>
  <message>
   <source>not saved: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/saving.py]</extracomment>
   <translation>non enregistré : {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks stay as they were: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>les repères du jeu restent ce qu’ils étaient : {why}</translation>
  </message>
  <message>
   <source>{title} is at {place} m, ± {deviations}, from {views} views</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} est à {place} m, ± {deviations}, d’après {views} vues</translation>
  </message>
  <message>
   <source>{title} was deleted meanwhile: its place was not kept</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} a été supprimé entre-temps : son lieu n’a pas été gardé</translation>
  </message>
  <message>
   <source>left out: {names}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>laissés de côté : {names}</translation>
  </message>
  <message>
   <source>the dataset's landmarks are not used: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>les repères du jeu ne sont pas utilisés : {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks can be used again</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>les repères du jeu sont de nouveau utilisables</translation>
  </message>
  <message>
   <source>{names} share only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} ne disent que où se voient les éléments, sans caméra : pas de sol à comparer.</translation>
  </message>
  <message>
   <source>{names}: no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} : pas de caméra pour cette image.</translation>
  </message>
  <message>
   <source>{name} shares only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{name} ne dit que où se voient les éléments, sans caméra : pas de sol à comparer.</translation>
  </message>
  <message>
   <source>{a} and {b}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{a} et {b}</translation>
  </message>
  <message>
   <source>The two see no part of the field in common in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Les deux ne voient aucune partie commune du terrain sur cette image.</translation>
  </message>
  <message>
   <source>Both cameras are the same in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Les deux caméras sont identiques sur cette image.</translation>
  </message>
  <message>
   <source>No source is judged: choose one first.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Aucune source n’est jugée : choisissez-en d’abord une.</translation>
  </message>
  <message>
   <source>Two sources of cameras are needed: load another one.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Il faut deux sources de caméras : chargez-en une autre.</translation>
  </message>
  <message>
   <source>The fitted camera sees no part of the field.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>La caméra ajustée ne voit aucune partie du terrain.</translation>
  </message>
  <message>
   <source>There is no fit of this frame, so no uncertainty map.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Pas d’ajustement de cette image, donc pas de carte d’incertitude.</translation>
  </message>
  <message>
   <source>No camera yet, so no uncertainty map: {why}.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Pas encore de caméra, donc pas de carte d’incertitude : {why}.</translation>
  </message>
  <message>
   <source>the painted width cannot be drawn: {why}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>la largeur peinte ne peut être tracée : {why}</translation>
  </message>
  <message>
   <source>{file} says what the field of this dataset is: to choose another one, move that file away and open the dataset again</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>{file} dit quel est le terrain de ce jeu : pour en choisir un autre, écartez ce fichier et rouvrez le jeu</translation>
  </message>
  <message>
   <source>field: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>terrain : {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>le terrain de ce jeu désormais : {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on, {reach}: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>le terrain de ce jeu désormais, {reach} : {field}</translation>
  </message>
  <message>
   <source>no other field knows the classes here better</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>aucun autre terrain ne connaît mieux ces classes</translation>
  </message>
  <message>
   <source>{folder} cannot be written: what is annotated here has to be saved elsewhere (File &gt; Save copies to…)</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>impossible d’écrire dans {folder} : ce qui est annoté ici doit être enregistré ailleurs (Fichier &gt; Enregistrer des copies dans…)</translation>
  </message>
  <message>
   <source>not everything is saved yet: the other dataset was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>tout n’est pas encore enregistré : l’autre jeu n’a pas été ouvert</translation>
  </message>
  <message>
   <source>not everything is saved yet: the video was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>tout n’est pas encore enregistré : la vidéo n’a pas été ouverte</translation>
  </message>
  <message>
   <source>nothing is open</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>rien n’est ouvert</translation>
  </message>
  <message>
   <source>unfinished elements were kept: {titles}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>des éléments inachevés sont conservés : {titles}</translation>
  </message>
  <message>
   <source>the field of this dataset: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>le terrain de ce jeu : {field}</translation>
  </message>
  <message>
   <source>the filter shows no further frame this way</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>le filtre ne montre plus d’image dans ce sens</translation>
  </message>
  <message>
   <source>you rejected it (Ctrl+Z takes that back)</source>
   <extracomment>[procc_annotator/gui/state/prediction/camera_choice.py]</extracomment>
   <translation>vous l’avez rejetée (Ctrl+Z annule cela)</translation>
  </message>
  <message>
   <source>draw 3 elements, two of which meet, such as {names}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>dessinez 3 éléments, dont deux qui se rejoignent, comme {names}</translation>
  </message>
  <message>
   <source>{title}: its line could not be looked for: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>{title} : sa ligne n’a pu être recherchée : {why}</translation>
  </message>
  <message>
   <source>chosen automatically</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>choisi automatiquement</translation>
  </message>
  <message>
   <source>H: homography of the ground</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>H : homographie du sol</translation>
  </message>
  <message>
   <source>P: pinhole</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>P : sténopé</translation>
  </message>
  <message>
   <source>R: pinhole, lens distortion</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R : sténopé, distorsion de l’objectif</translation>
  </message>
  <message>
   <source>R+: R, aspect ratio, principal point</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R+ : R, rapport d’aspect, point principal</translation>
  </message>
  <message>
   <source>R2: R+, second radial coefficient</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R2 : R+, second coefficient radial</translation>
  </message>
  <message>
   <source>F: fisheye</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>F : fisheye</translation>
  </message>
  <message>
   <source>the fit failed: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py]</extracomment>
   <translation>l’ajustement a échoué : {why}</translation>
  </message>
  <message>
   <source>{who} unlocked this dataset from blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} a levé le mode aveugle de ce jeu le {day}</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} était {status} et est de nouveau en cours</translation>
  </message>
  <message>
   <source>for you alone: the dataset's folder cannot be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>pour vous seul : impossible d’écrire dans le dossier du jeu</translation>
  </message>
  <message>
   <source>{reason}: there is no live fit in it</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason} : il n’y a pas d’ajustement continu</translation>
  </message>
  <message>
   <source>This dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Le mode aveugle est imposé à ce jeu de données</translation>
  </message>
  <message>
   <source>Somebody</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Quelqu’un</translation>
  </message>
  <message>
   <source>{who} locked this dataset to blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} a imposé le mode aveugle à ce jeu le {day}</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again: edited after the cameras were shown, it is no blind work any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} était {status} et est de nouveau en cours : modifiée après l’affichage des caméras, ce n’est plus du travail à l’aveugle</translation>
  </message>
  <message>
   <source>in this window only: nothing can be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>dans cette fenêtre seulement : rien ne peut être écrit</translation>
  </message>
  <message>
   <source>this dataset is not locked to blind mode any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>le mode aveugle n’est plus imposé à ce jeu de données</translation>
  </message>
  <message>
   <source>{reason}: menu Frame unlocks it, which is recorded</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason} : le menu Image le lève, ce qui est consigné</translation>
  </message>
  <message>
   <source>this dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>le mode aveugle est imposé à ce jeu de données</translation>
  </message>
  <message>
   <source>{path}: no camera has the name of a frame (cameras are named like {camera!r}, frames like {frame!r})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path} : aucune caméra n’a le nom d’une image (les caméras s’appellent comme {camera!r}, les images comme {frame!r})</translation>
  </message>
  <message>
   <source>{path}: no cameras in it ({what_to_do})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path} : pas de caméras dedans ({what_to_do})</translation>
  </message>
  <message numerus="yes">
   <source>no class of this field: {n} labels ({names})</source>
   <extracomment>no class of this field: {n} label ({names}) / no class of this field: {n} labels ({names}) [procc_annotator/gui/state/second.py]</extracomment>
   <translation>
    <numerusform>sans classe sur ce terrain : {n} étiquette ({names})</numerusform>
    <numerusform>sans classe sur ce terrain : {n} étiquettes ({names})</numerusform>
   </translation>
  </message>
  <message>
   <source>{path}: holds no annotation (*.json)</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>{path} : ne contient aucune annotation (*.json)</translation>
  </message>
  <message>
   <source>second annotator: {why}</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>second annotateur : {why}</translation>
  </message>
  <message>
   <source>{who} is editing it; it opens by itself once they leave it</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} la modifie ; elle s’ouvre d’elle-même dès qu’elle est quittée</translation>
  </message>
  <message>
   <source>nothing annotated yet</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>rien n’est encore annoté</translation>
  </message>
  <message>
   <source>{who} on {machine}</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} sur {machine}</translation>
  </message>
  <message>
   <source>annotation cannot be read</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>l’annotation est illisible</translation>
  </message>
  <message>
   <source>Enter runs it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Entrée exécute · ↑ ↓ choisissent · Échap ferme</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Panneau</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Paramètre</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ouvrir</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Une action, un élément, une image, une source, un dossier, un nombre</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Rechercher</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Rien ne s’appelle « {text} ».</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Seuil {px:g} px</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Image {number} sur {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Aller à cette image</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juger les éléments avec ce tau</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ce qui convient</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juger {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juger avec cette source</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ajustement continu : modèle {model}</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Panneau {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ouvrir ce panneau et le mettre devant</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>activé</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>désactivé</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action guide]</extracomment>
   <translation>Guide</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Chercher des mots dans cette page</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Le guide est en anglais.</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>le guide n’est pas fourni avec cette installation</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>À propos de ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Annoter et auditer des calibrations de caméras de sport.</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Titres</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>aucune caméra n’est chargée (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>chargez un second jeu de caméras pour les voir côte à côte (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>chargez un second jeu de caméras pour comparer (Ctrl+L)</translation>
  </message>
  <message>
   <source>Brightness</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Luminosité</translation>
  </message>
  <message>
   <source>Contrast</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Contraste</translation>
  </message>
  <message>
   <source>Gamma</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Gamma</translation>
  </message>
  <message>
   <source>Bring out worn and shaded lines</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Faire ressortir les lignes usées ou dans l’ombre</translation>
  </message>
  <message>
   <source>Only what you see changes, never the file</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Seul ce que vous voyez change, jamais le fichier</translation>
  </message>
  <message>
   <source>Reset</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Réinitialiser</translation>
  </message>
  <message>
   <source>Shift all values</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Décaler toutes les valeurs</translation>
  </message>
  <message>
   <source>Stretch values about middle grey</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Étirer les valeurs autour du gris moyen</translation>
  </message>
  <message>
   <source>To the right, dark parts become lighter</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Vers la droite, les parties sombres s’éclaircissent</translation>
  </message>
  <message>
   <source>Line enhance</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Rehausser les lignes</translation>
  </message>
  <message>
   <source>Show the picture as it is</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Montrer l’image telle qu’elle est</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Vos propres touches</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Touches (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu} : {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Recherche : un mot ou une touche. Un clic fait ce que dit une ligne.</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Dans l’image</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Aucune touche, action ni élément ne contient « {text} ».</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Recherche : un mot ou une touche</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Choisir une ligne, puis presser ses touches</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{one} ou {other}</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, the action keys]</extracomment>
   <translation>Touches</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Changer les touches</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Seulement celles-ci</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Aucune touche</translation>
  </message>
  <message>
   <source>Default keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Touches par défaut</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Importer…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ Des touches qui appellent deux actions n’en appellent aucune : donnez-en d’autres à l’une d’elles.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Exporter les touches</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Importer des touches</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Nouvelles touches : pressez-les ici</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Chercher dans les touches</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Recherche</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Toutes les touches d’un coup</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{file} : {error} ; les touches restent ce qu’elles sont</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Action ou élément</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ aussi : {what}</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Changer la classe en (échange avec une annotée)</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Dessin de {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Couper ici : le reste devient</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Fantôme de {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Accepter</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Regarder de près</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/menus.py, the action not_visible]</extracomment>
   <translation>Pas visible ici</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action} : {step}</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Point {number} de {title}</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Pas visible ici : revenir dessus</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Fusionner dans</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title}, non confirmé</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>sol ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>unexpected error ({what}); saving goes on, the details are in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>erreur inattendue ({what}) ; l’enregistrement continue, les détails sont dans {path}</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Curseur en pixels de l’image ; le centre du pixel en haut à gauche est 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Curseur au sol du terrain, en mètres depuis son centre</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>À quelle distance la caméra active et la caméra comparée voient le curseur :
au sol, et en pixels de la taille d’évaluation</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Avec quelle sûreté la caméra ajustée connaît le point du sol au curseur : écart type
dans la pire direction, quelle que soit l’erreur du curseur lui-même</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>notation {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Caméra &gt; Arrêter de noter le jeu y met fin</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>comparaison {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>fantômes {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Échap y met fin</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cette image n’est pas modifiable. {problem}</translation>
  </message>
  <message>
   <source>the details are copied; they are in {path}, too</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>les détails sont copiés ; ils sont aussi dans {path}</translation>
  </message>
  <message>
   <source>there was no unexpected error; they are logged in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>il n’y a pas eu d’erreur inattendue ; elles sont consignées dans {path}</translation>
  </message>
  <message>
   <source>not editable: the bar over the picture says why</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>non modifiable : la barre sur l’image dit pourquoi</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Image
Luminosité, contraste, gamma, rehaussement des lignes : seul ce que vous voyez change</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Barre d’outils</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Indice de Jaccard de cette image à tau</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Seuil tau : un élément passe si tous ses points sont plus proches (+ et -)</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Le jeu de caméras qui est jugé (C change)</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>État de cette image (panneau Relecture)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Avec quoi le score est calculé : {terms}</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>enregistré {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>
    <numerusform>NON ENREGISTRÉE : {n} image</numerusform>
    <numerusform>NON ENREGISTRÉES : {n} images</numerusform>
   </translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Terrain : {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Cliquer pour en choisir un autre</translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>enregistrement...</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Seuil tau</translation>
  </message>
  <message>
   <source>JaC {jac:.3f} of the fit</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>JaC {jac:.3f} (fit)</translation>
  </message>
  <message>
   <source>blind: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>aveugle : à remettre</translation>
  </message>
  <message>
   <source>{n} of {total}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>{n} sur {total}</translation>
  </message>
  <message>
   <source>The camera is found without a click; dashed: what it expects. Shift+Enter accepts that</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>La caméra est trouvée sans un clic ; en tirets : ce qu’elle attend. Maj+Entrée l’accepte</translation>
  </message>
  <message>
   <source>W switches to editing: drag a point off its line</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>W passe à l’édition : tirez un point hors de sa ligne</translation>
  </message>
  <message>
   <source>The tab Check lists possible mistakes: open it. F12 applies the first remedy</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>L’onglet « Vérification » montre les erreurs possibles : ouvrez-le. F12 applique le premier remède</translation>
  </message>
  <message>
   <source>Ctrl+Enter: this frame is done</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Entrée : cette image est terminée</translation>
  </message>
  <message>
   <source>Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press Enter, choose its name</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Maj+D : une image sans annotation. W, puis tracez une ligne : cliquez ses bouts, Entrée, choisissez son nom</translation>
  </message>
  <message>
   <source>Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your annotation</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>« Juger », en haut à droite (Maj+F2), puis C : la caméra ajustée, jugée d’après votre annotation</translation>
  </message>
  <message>
   <source>File &gt; Export as… writes the annotations for other programs: look at it</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Fichier &gt; Exporter sous… écrit les annotations pour d’autres logiciels : regardez</translation>
  </message>
  <message>
   <source>That was the tour. Shift+F1: back to annotating; F1: all keys</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>La visite est finie. Maj+F1 : revenir à l’annotation ; F1 : toutes les touches</translation>
  </message>
  <message>
   <source>Go on to the next step</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Passer à l’étape suivante</translation>
  </message>
  <message>
   <source>Esc ends the tour, too</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Échap termine aussi la visite</translation>
  </message>
  <message>
   <source>Skip</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Passer</translation>
  </message>
  <message>
   <source>End</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Terminer</translation>
  </message>
  <message>
   <source>the sample cannot be copied: {why}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>l’exemple ne peut être copié : {why}</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Déposez un dossier d’images ici</translation>
  </message>
  <message>
   <source>Annotations are read from and saved as JSON next to the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Les annotations sont lues et enregistrées en JSON à côté des images. Déposez plus tard un dossier de caméras pour les voir jugées d’après vos clics.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Ouvrir un récent</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Ouvrir un dossier…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Ouvrir une image…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Ouvrir une vidéo…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Essayer l’exemple</translation>
  </message>
  <message>
   <source>Tour (60 seconds)</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action tour]</extracomment>
   <translation>Visite (60 secondes)</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Continuer avec</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Rien n’a encore été ouvert</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>{setting} : revenir à {value}</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Aucun paramètre ne contient « {text} ».</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Paramètres</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Chercher dans les paramètres</translation>
  </message>
  <message>
   <source>Reset all</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Tout réinitialiser</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>aucun de votre choix</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py, the action keymap]</extracomment>
   <translation>Changer les touches…</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Scores</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Ajustement</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Vérification</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py, the action plots]</extracomment>
   <translation>Graphiques</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Relecture</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Accord</translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Annoter</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Juger</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Relire</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[procc_annotator/interaction/camera_view.py, the action disagreement]</extracomment>
   <translation>Désaccord</translation>
  </message>
  <message>
   <source>Uncertainty</source>
   <extracomment>[procc_annotator/interaction/camera_view.py]</extracomment>
   <translation>Incertitude</translation>
  </message>
  <message numerus="yes">
   <source>{n} to go</source>
   <extracomment>{n} to go / {n} to go [procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>
    <numerusform>encore {n}</numerusform>
    <numerusform>encore {n}</numerusform>
   </translation>
  </message>
  <message>
   <source>choose an element first: field map, list, or its key</source>
   <extracomment>[procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>choisissez d’abord un élément : plan du terrain, liste ou touche</translation>
  </message>
  <message>
   <source>{title} is pinned, so that a slip does not move it: drag its points, or unpin elements (Ctrl+P, menu Element) to drag it as a whole</source>
   <extracomment>[procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>{title} est épinglé, pour qu’un faux geste ne le bouge pas : glissez ses points, ou libérez les éléments (Ctrl+P, menu Élément) pour le glisser en entier</translation>
  </message>
  <message numerus="yes">
   <source>move {n} points</source>
   <extracomment>move {n} point / move {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>déplacer {n} point</numerusform>
    <numerusform>déplacer {n} points</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>delete {n} points</source>
   <extracomment>delete {n} point / delete {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>supprimer {n} point</numerusform>
    <numerusform>supprimer {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>draw {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>dessiner {title}</translation>
  </message>
  <message>
   <source>continue {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>continuer {title}</translation>
  </message>
  <message>
   <source>confirm {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>confirmer {title}</translation>
  </message>
  <message>
   <source>move {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>déplacer {title}</translation>
  </message>
  <message>
   <source>move all of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>déplacer tout {title}</translation>
  </message>
  <message>
   <source>nudge {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>décaler {title}</translation>
  </message>
  <message>
   <source>insert a point in {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>insérer un point dans {title}</translation>
  </message>
  <message>
   <source>delete {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>supprimer {title}</translation>
  </message>
  <message>
   <source>delete point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>supprimer le point {number} de {title}</translation>
  </message>
  <message numerus="yes">
   <source>nudge {n} points</source>
   <extracomment>nudge {n} point / nudge {n} points [procc_annotator/interaction/gestures.py]</extracomment>
   <translation>
    <numerusform>décaler {n} point</numerusform>
    <numerusform>décaler {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>click to draw; choose its class afterwards</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>cliquer pour dessiner ; choisir la classe ensuite</translation>
  </message>
  <message>
   <source>Backspace removes the last point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Retour arrière retire le dernier point</translation>
  </message>
  <message>
   <source>click marks it and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le marque et passe à {title}</translation>
  </message>
  <message>
   <source>release drops it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>relâcher le dépose ici</translation>
  </message>
  <message>
   <source>click or drag a point, drag elsewhere to select several</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>cliquer ou glisser un point ; glisser ailleurs pour en choisir plusieurs</translation>
  </message>
  <message>
   <source>arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>les flèches déplacent de {step:g} px, avec Maj {fine:g} px, Ctrl {far:g} px</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here, or open one with Ctrl+O</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Déposez un dossier d’images ici, ou ouvrez-en un avec Ctrl+O</translation>
  </message>
  <message>
   <source>Ctrl+Enter commits the frame and shows the projection</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ctrl+Entrée remet l’image et montre la projection</translation>
  </message>
  <message>
   <source>GHOST {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>FANTÔME {title}</translation>
  </message>
  <message>
   <source>GHOST the next one comes in a moment</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>FANTÔME le suivant arrive dans un instant</translation>
  </message>
  <message numerus="yes">
   <source>Tab: next of {n} ghosts</source>
   <extracomment>Tab: next of {n} ghost / Tab: next of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab : suivant de {n} fantôme</numerusform>
    <numerusform>Tab : suivant de {n} fantômes</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Tab: first of {n} ghosts</source>
   <extracomment>Tab: first of {n} ghost / Tab: first of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab : premier de {n} fantôme</numerusform>
    <numerusform>Tab : premier de {n} fantômes</numerusform>
   </translation>
  </message>
  <message>
   <source>Shift+Enter: accept all</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Maj+Entrée : tout accepter</translation>
  </message>
  <message>
   <source>Enter accepts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée l’accepte</translation>
  </message>
  <message>
   <source>Tab goes on</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Tab continue</translation>
  </message>
  <message>
   <source>. not visible here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>. pas visible ici</translation>
  </message>
  <message>
   <source>Esc goes back</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap revient</translation>
  </message>
  <message>
   <source>/ finds an element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>/ trouve un élément</translation>
  </message>
  <message>
   <source>DRAW</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DESSINER</translation>
  </message>
  <message>
   <source>choose an element: field map, list, its key or /</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>choisissez un élément : plan du terrain, liste, touche ou /</translation>
  </message>
  <message numerus="yes">
   <source>DRAW a line, {n} points</source>
   <extracomment>DRAW a line, {n} point / DRAW a line, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>DESSINER une ligne, {n} point</numerusform>
    <numerusform>DESSINER une ligne, {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes, then choose the class</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée ou double-clic termine ; choisir ensuite la classe</translation>
  </message>
  <message numerus="yes">
   <source>DRAW {title}, {n} points</source>
   <extracomment>DRAW {title}, {n} point / DRAW {title}, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>DESSINER {title}, {n} point</numerusform>
    <numerusform>DESSINER {title}, {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée ou double-clic termine</translation>
  </message>
  <message>
   <source>click adds the second point and finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic pose le second point et termine</translation>
  </message>
  <message>
   <source>click adds a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic pose un point</translation>
  </message>
  <message>
   <source>DRAW {title}, unconfirmed</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DESSINER {title}, non confirmé</translation>
  </message>
  <message>
   <source>DRAW {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DESSINER {title}</translation>
  </message>
  <message>
   <source>Enter confirms it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée le confirme</translation>
  </message>
  <message>
   <source>choose it again, then clicks continue it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>le choisir à nouveau, puis les clics le continuent</translation>
  </message>
  <message numerus="yes">
   <source>click continues it after its {n} points</source>
   <extracomment>click continues it after its {n} point / click continues it after its {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>un clic le continue après son {n} point</numerusform>
    <numerusform>un clic le continue après ses {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>click starts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le commence</translation>
  </message>
  <message>
   <source>click moves it here and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le déplace ici et passe à {title}</translation>
  </message>
  <message>
   <source>Enter confirms {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée confirme {title}</translation>
  </message>
  <message numerus="yes">
   <source>Esc deselects {n} points</source>
   <extracomment>Esc deselects the point / Esc deselects {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Échap désélectionne le point</numerusform>
    <numerusform>Échap désélectionne {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>EDIT</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ÉDITER</translation>
  </message>
  <message>
   <source>release selects all points inside</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>relâcher choisit tous les points à l’intérieur</translation>
  </message>
  <message>
   <source>EDIT point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ÉDITER le point {number} de {title}</translation>
  </message>
  <message>
   <source>release selects the element, which is pinned</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>relâcher sélectionne l’élément, qui est épinglé</translation>
  </message>
  <message>
   <source>EDIT the element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ÉDITER l’élément</translation>
  </message>
  <message>
   <source>drag moves point {number} of {title}, Alt+Shift+click removes it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>glisser déplace le point {number} de {title}, Alt+Maj+clic le retire</translation>
  </message>
  <message>
   <source>click selects {title}, Alt+click inserts a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic sélectionne {title}, Alt+clic insère un point</translation>
  </message>
  <message>
   <source>click does nothing: there are no points to edit, draw an element first</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic ne fait rien : il n’y a pas de points à éditer, dessinez d’abord un élément</translation>
  </message>
  <message>
   <source>click a point to drag it, elsewhere to deselect</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>cliquer un point pour le glisser, ailleurs pour désélectionner</translation>
  </message>
  <message numerus="yes">
   <source>Delete removes {n} points</source>
   <extracomment>Delete removes the point / Delete removes {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Suppr retire le point</numerusform>
    <numerusform>Suppr retire {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>click draws it by hand</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le dessine à la main</translation>
  </message>
  <message numerus="yes">
   <source>Enter accepts {n} points</source>
   <extracomment>Enter accepts {n} point / Enter accepts {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Entrée accepte {n} point</numerusform>
    <numerusform>Entrée accepte {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>no line found along it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>aucune ligne trouvée dessus</translation>
  </message>
  <message>
   <source>an element's key names it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>la touche d’un élément la nomme</translation>
  </message>
  <message>
   <source>Enter or double-click finishes and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entrée ou double-clic termine et passe à {title}</translation>
  </message>
  <message>
   <source>Esc cancels</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap abandonne</translation>
  </message>
  <message>
   <source>Esc deselects</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap désélectionne</translation>
  </message>
  <message>
   <source>click moves it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le déplace ici</translation>
  </message>
  <message>
   <source>click marks it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic le marque</translation>
  </message>
  <message>
   <source>hold Ctrl: no snapping</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>maintenir Ctrl : sans aimant</translation>
  </message>
  <message>
   <source>Delete removes {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Suppr retire {title}</translation>
  </message>
  <message>
   <source>EDIT choosing points</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ÉDITER choix de points</translation>
  </message>
  <message numerus="yes">
   <source>EDIT {n} points</source>
   <extracomment>EDIT {n} point / EDIT {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>ÉDITER {n} point</numerusform>
    <numerusform>ÉDITER {n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>READ ONLY</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>LECTURE SEULE</translation>
  </message>
  <message>
   <source>BLIND</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>AVEUGLE</translation>
  </message>
  <message>
   <source>Shift+Enter finishes and stays</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Maj+Entrée termine et reste</translation>
  </message>
  <message>
   <source>Esc removes the new point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap retire le nouveau point</translation>
  </message>
  <message>
   <source>Esc lets go</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Échap lâche</translation>
  </message>
  <message>
   <source>passes</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>passe</translation>
  </message>
  <message>
   <source>too far</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>trop loin</translation>
  </message>
  <message>
   <source>annotated, not projected</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>annoté, non projeté</translation>
  </message>
  <message>
   <source>projected, not annotated</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>projeté, non annoté</translation>
  </message>
  <message>
   <source>ghost of an unsure camera</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>fantôme d’une caméra incertaine</translation>
  </message>
  <message>
   <source>ghost: expected here</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>fantôme : attendu ici</translation>
  </message>
  <message>
   <source>annotated, in its class's colour</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>annoté, dans la couleur de sa classe</translation>
  </message>
  <message>
   <source>to be confirmed</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>à confirmer</translation>
  </message>
  <message>
   <source>projection</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>projection</translation>
  </message>
  <message>
   <source>second annotator</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>second annotateur</translation>
  </message>
  <message>
   <source>no distance</source>
   <extracomment>[procc_annotator/interaction/overlay_primitives.py]</extracomment>
   <translation>pas de distance</translation>
  </message>
  <message>
   <source>not annotated</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>non annoté</translation>
  </message>
  <message>
   <source>missed</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>manqué</translation>
  </message>
  <message>
   <source>{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} convient : son point le plus loin, le {number}, est à {px} px ; il passe à tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} est trop loin : le point {number} est à {px} px ; il passe à tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{title} (judged as {other}, labels mirrored)</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{title} (jugé comme {other}, classes en miroir)</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the camera does not show it in the picture.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} est manqué : il est annoté, mais la caméra ne le montre pas dans l’image.</translation>
  </message>
  <message>
   <source>{element} is not annotated, but the camera shows it: a false positive.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} n’est pas annoté, mais la caméra le montre : un faux positif.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} has no distance, because the projection has coinciding samples there; it passes at no tau.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} est trop loin : le point {number} n’a pas de distance, car la projection y a des échantillons confondus ; il ne passe à aucun tau.</translation>
  </message>
  <message>
   <source>As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what is in the picture alone.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>Tel qu’il continue au-delà de l’image il est au plus à {px} px, mais soccernet ne mesure que jusqu’à ce qui est dans l’image.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the field has no such element to project.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} est manqué : il est annoté, mais le terrain n’a pas un tel élément à projeter.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but it leaves the ground, and the camera knows only the ground.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} est manqué : il est annoté, mais il quitte le sol, et la caméra ne connaît que le sol.</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Annoter toutes les images d’un dossier</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Annoter une seule image</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Annoter les images d’une vidéo sans les extraire auparavant</translation>
  </message>
  <message>
   <source>Season…</source>
   <extracomment>[the action season]</extracomment>
   <translation>Saison…</translation>
  </message>
  <message>
   <source>List the matches of a season (a folder in which videos lie) to open one of them</source>
   <extracomment>[the action season]</extracomment>
   <translation>Lister les matchs d’une saison (un dossier qui contient des vidéos) pour en ouvrir un</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Ouvrir l’exemple</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Ouvrir votre propre copie des images fournies avec le programme</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Ouvrir un second annotateur…</translation>
  </message>
  <message>
   <source>Draw and compare what another annotator clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Dessiner et comparer ce qu’une autre personne a cliqué sur les mêmes images</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Fermer le second annotateur</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>N’afficher à nouveau que les annotations de ce jeu de données</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Depuis un fichier…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Votre propre description : n’importe quel sport, voir le guide</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Passer au terrain qui convient</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Afficher le terrain qui connaît les classes annotées sur cette image</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Relire le fichier</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Se fait tout seul quand le fichier du terrain de ce jeu de données est écrit</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Enregistrer maintenant</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Toute modification terminée est enregistrée aussitôt ; ceci réessaie ce qui a échoué</translation>
  </message>
  <message>
   <source>Write what could not be saved in its own place to another folder</source>
   <extracomment>[the action save_copies]</extracomment>
   <translation>Écrire dans un autre dossier ce qui n’a pu être enregistré à sa place</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Importer des annotations…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Reprendre dans ce jeu, image par image, les annotations d’un autre programme ou jeu de données</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exporter sous…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Écrire les annotations pour un autre programme : CVAT, labelme, COCO, SoccerNet, masques</translation>
  </message>
  <message>
   <source>Export annotations as JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Exporter les annotations en JSON…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of JSON files</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Écrire les annotations de toutes les images dans un dossier ou un zip de fichiers JSON</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Exporter le JaC du jeu…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Écrire le JaC de chaque image en CSV ou JSON</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Exporter la provenance…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Écrire dans un JSON d’accompagnement comment chaque point est né, et par qui</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Enregistrer l’image superposée…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Écrire l’image avec annotation, projection et légende en PNG, JPEG ou SVG</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Exporter la vue d’ensemble…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Écrire l’état, les nombres et le temps de chaque image en CSV</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Exporter les verdicts…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Écrire en CSV à qui la faute sur quelle image, avec le JaC et la plus grande erreur</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Exporter les constats…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Écrire en CSV ce que la vérification des classes a trouvé dans les images vérifiées jusqu’ici</translation>
  </message>
  <message>
   <source>Author name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Nom de l’auteur…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>Le nom que portent vos points, commentaires et versions</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Quitter</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Fermer la fenêtre ; tout est enregistré</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Annuler</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Revenir sur la dernière étape de cette image</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Rétablir</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Refaire l’étape</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Supprimer le point ou l’élément</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Retirer le point sélectionné ; à défaut, l’élément sélectionné</translation>
  </message>
  <message>
   <source>Insert point</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Insérer un point</translation>
  </message>
  <message>
   <source>Put a point on the line at the crosshair, or at the mouse (Alt and a click do it, too)</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Mettre un point sur la ligne au réticule, ou à la souris (Alt et un clic le font aussi)</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Choisir tous les points</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Choisir tous les points de l’élément sélectionné, ou de l’image</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Abandonner les points qui viennent d’être cliqués, puis lâcher la sélection</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Paramètres…</translation>
  </message>
  <message>
   <source>Theme, text size, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Thème, taille des textes, et comment la fenêtre dessine, ajuste et juge</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Avec les flèches</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Déplacer de 1 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px à droite</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px en haut</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px en bas</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Déplacer de 0.1 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px à droite</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px en haut</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px en bas</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Déplacer de 10 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px à droite</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px en haut</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px en bas</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Déplacer de 100 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px à droite</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px en haut</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px en bas</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Image suivante</translation>
  </message>
  <message>
   <source>Show the next picture, of those that the filter shows</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Afficher l’image suivante, parmi celles que montre le filtre</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Image précédente</translation>
  </message>
  <message>
   <source>Show the previous picture, of those that the filter shows</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Afficher l’image précédente, parmi celles que montre le filtre</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Suivante non terminée</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Aller à la prochaine image ni terminée ni approuvée</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Précédente non terminée</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Revenir à l’image précédente ni terminée ni approuvée</translation>
  </message>
  <message>
   <source>Go to</source>
   <extracomment>[the menus]</extracomment>
   <translation>Aller à</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Suivante rejetée</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Aller à la prochaine image renvoyée par un relecteur</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Plus mauvais JaC suivant</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>L’image au JaC le plus bas ; une fois de plus : la suivante, un peu meilleure</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Plus grande erreur suivante</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>L’image où un point a la plus grande erreur ; une fois de plus : la suivante, plus petite</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Suivante par désaccord</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>L’image où la source active et la source comparée sont le plus éloignées au sol ; une fois de plus : la suivante</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Vérification des classes</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Constat suivant</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Aller au prochain constat de la vérification, image par image</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Constat précédent</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Revenir au constat précédent</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Appliquer le premier remède</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Corriger le constat actuel : renommer, échanger, retirer le mauvais point, ou aller voir</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Suivante sans annotation</translation>
  </message>
  <message>
   <source>Go to the next frame without annotations</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Aller à la prochaine image où rien n’est annoté</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Précédente sans annotation</translation>
  </message>
  <message>
   <source>Go to the previous frame without annotations</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Revenir à l’image précédente où rien n’est annoté</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Première image</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Afficher la première image</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Dernière image</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Afficher la dernière image</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Plan</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Suivre le plan</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Trouver les caméras de toutes les images de ce plan, à partir de celle-ci dans les deux sens ; une fois de plus arrête</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Accepter le passage</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; annotated ones are left out, and doubtful ones unless it is pressed again</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Annote les images du plan, ou de la portion marquée sur la bande, d’après leur suivi ; les images annotées sont omises, les douteuses aussi sauf si l’on appuie encore une fois</translation>
  </message>
  <message>
   <source>Annotate all that is sure</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Annoter tout ce qui est sûr</translation>
  </message>
  <message>
   <source>Annotate every frame of the dataset whose camera is found and sure, in one step; Next doubtful frame (Alt+PgDown) then goes through the others, the least sure first</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Annoter en une étape chaque image du jeu dont la caméra est trouvée et sûre ; « Image douteuse suivante » (Alt+Page suiv.) parcourt ensuite les autres, les moins sûres d’abord</translation>
  </message>
  <message>
   <source>Take back what was accepted last</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Revenir sur la dernière acceptation</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Les images acceptées en dernier et non modifiées depuis redeviennent ce qu’elles étaient</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Dix images plus loin</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Avancer de dix images</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Dix images en arrière</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Reculer de dix images</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Image annotée suivante</translation>
  </message>
  <message>
   <source>Go on to the next frame that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Aller à la prochaine image annotée</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Image annotée précédente</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Revenir à l’image annotée précédente</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Image douteuse suivante</translation>
  </message>
  <message>
   <source>Go to the next frame whose track should be checked</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Aller à la prochaine image dont le suivi est à regarder</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Image douteuse précédente</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Revenir à l’image douteuse précédente</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Lecture ou pause</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Montrer les images l’une après l’autre ; une fois de plus, ou toute modification, arrête</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Trouver une image…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Taper une partie du nom de l’image</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Mode aveugle</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Cacher la projection jusqu’à la remise de l’image, pour que la caméra n’attire pas les clics</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Imposer le mode aveugle au jeu de données</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Mode aveugle pour tous ceux qui annotent ce jeu ; le lever demande confirmation et est consigné</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Terminée</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Cette image est terminée ; en mode aveugle, cela montre la projection</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Un relecteur trouve cette image correcte</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Un relecteur renvoie cette image ; dites pourquoi dans un commentaire</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>De nouveau en cours</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Cette image n’est finalement pas terminée</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Commentaire…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Écrire dans la discussion de cette image</translation>
  </message>
  <message>
   <source>Comment on this place…</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Commenter cet endroit…</translation>
  </message>
  <message>
   <source>Write a comment on the place at the cursor; a numbered pin marks it in the picture</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Écrire un commentaire sur l’endroit du curseur ; une épingle numérotée le marque dans l’image</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Versions antérieures…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Voir toutes les versions enregistrées de cette image et en restaurer une</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Grouper les vues…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Dire d’après leurs noms quelles images montrent le même instant depuis plusieurs caméras</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Garder cette image de la vidéo</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture next to its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Écrire l’image de la vidéo comme fichier à côté de son annotation</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Copier de l’image précédente</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Reprendre les éléments de l’image annotée avant, déplacés comme la caméra ; ils attendent d’être confirmés</translation>
  </message>
  <message>
   <source>Confirm all unconfirmed elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Confirmer tous les éléments non confirmés</translation>
  </message>
  <message>
   <source>Copied and unfinished elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Les éléments copiés et inachevés comptent et sont enregistrés désormais</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Écarter les éléments non confirmés</translation>
  </message>
  <message>
   <source>Remove copied and unfinished elements that were not edited</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Retirer les éléments copiés et inachevés qui n’ont pas été modifiés</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Régulariser tous les éléments</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Rééchantillonner chaque élément de l’image le long de sa ligne peinte</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Dessiner</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Les clics ajoutent des points à l’élément choisi</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Glisser, insérer et retirer des points</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Passer du dessin à l’édition</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Du dessin à l’édition et retour</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Élément suivant</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Choisir l’élément suivant du terrain</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Élément précédent</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Choisir l’élément précédent</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Trouver un élément…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Taper une partie du nom de l’élément</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Terminer l’élément</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Faire un élément des points qui viennent d’être cliqués (ou double-cliquer le dernier)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminer et rester</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminer l’élément sans passer au suivant</translation>
  </message>
  <message>
   <source>Remove the last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Retirer le dernier point</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Retirer le point cliqué en dernier</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Supprimer l’élément</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Retirer l’élément sélectionné avec tous ses points</translation>
  </message>
  <message>
   <source>Confirm element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Confirmer l’élément</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>L’élément sélectionné compte et est enregistré désormais (en mode édition : Entrée)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Régulariser</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Rééchantillonner l’élément le long de sa ligne peinte : deux clics font un élément droit, cinq une courbe</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Fermer les écarts</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Prolonger les bouts de l’élément jusqu’au coin ou au bord de l’image qu’ils n’atteignent pas</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Inverser</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Retourner l’ordre des points de l’élément</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Dupliquer vers la classe symétrique</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Mettre une copie sous la classe du terrain tourné, à glisser à sa place</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Aimanter aux lignes</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click off it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Les clics près d’une ligne peinte vont à son milieu (tenir Ctrl pour cliquer à côté)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Passer à l’élément suivant</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Après un élément terminé, choisir celui qui vient le plus probablement ensuite</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Deux clics terminent un élément droit</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Le second clic sur un élément droit le termine</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Dessiner d’abord, nommer ensuite</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Sans élément choisi, un clic commence une ligne ; une fois terminée, les éléments les plus probables sont proposés au bout du trait</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Épingler les éléments</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Seuls les points peuvent être glissés, pas les éléments entiers</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Fantômes</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Fantôme suivant</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Regarder de près le prochain élément que la caméra ajustée attend</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Fantôme précédent</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Regarder de près le précédent</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Accepter le fantôme</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Faire du fantôme un élément : des points sur sa ligne peinte, aucun là où elle est cachée (Entrée)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Accepter tous les fantômes</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Accepter tous les fantômes dont la ligne peinte se voit assez bien (Maj+Entrée tant que rien n’est en cours de dessin)</translation>
  </message>
  <message>
   <source>Accept all and go on</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Tout accepter et continuer</translation>
  </message>
  <message>
   <source>Accept all ghosts of this frame and show the next one: one key a frame</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Accepter tous les fantômes de cette image et montrer la suivante : une touche par image</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Part visible pour tout accepter…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Quelle part de sa ligne peinte doit se voir pour qu’un fantôme soit accepté avec tous les autres</translation>
  </message>
  <message>
   <source>The ghost or the chosen element cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>Le fantôme ou l’élément choisi ne se voit pas sur cette image ; une fois de plus revient dessus</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Revenir sur « pas visible ici »</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>L’élément dit en dernier non visible sur cette image se voit peut-être quand même</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Afficher les fantômes</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Tracer des courbes pâles là où la caméra ajustée attend des éléments pas encore annotés</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Chercher la caméra dans l’image</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Là où rien n’est encore annoté, trouver la caméra sans un clic et montrer ses éléments comme fantômes ; rien n’est enregistré avant d’être accepté</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Dire quoi annoter ensuite</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Marquer sur le plan du terrain l’élément qui rendrait la caméra ajustée la plus sûre</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Ajuster à la fenêtre</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Montrer toute l’image</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Taille réelle</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Un pixel de l’image est un pixel de l’écran</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Zoom avant</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Agrandir (la molette le fait au curseur)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Zoom arrière</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Réduire (la molette le fait au curseur)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Déplacer la vue</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Le bouton gauche déplace l’image (ou tenir Espace, ou bouton du milieu) ; Échap y met fin</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Garder le zoom d’une image à l’autre</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Rester à cet endroit de l’image quand l’image change</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Cacher les superpositions</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Montrer l’image nue (ou tenir X)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Colorer selon</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Critère</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Les couleurs disent comment la caméra est jugée</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Classe</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Chaque élément dans sa propre couleur</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Provenance</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Les points selon leur origine : cliqués, aimantés, régularisés, copiés, déplacés</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Annotateur</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Les points selon qui les a posés</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Largeur peinte</translation>
  </message>
  <message>
   <source>Draw how wide the field's lines must appear, along the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Tracer à côté de la projection la largeur que doit avoir la peinture des lignes du terrain</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Preuves de peinture</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Le long de chaque segment une bande : pleine où l’image montre de la peinture dessous, tiretée où la peinture passe à côté, de ce côté, pointillée où il n’y en a pas</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Loupe</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Garder la loupe au curseur (ou tenir Z ; elle vient aussi quand un point est glissé)</translation>
  </message>
  <message>
   <source>Legend in the picture</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Légende dans l’image</translation>
  </message>
  <message>
   <source>What the colours, dashes and marks over the picture mean, in its corner; it gives way to the hand</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Ce que signifient les couleurs, tirets et marques sur l’image, dans son coin ; elle cède la place à la main</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Tourner le plan vers la caméra</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Le plan a en bas le côté où se tient la caméra, et ce qu’elle ne voit pas est pâle</translation>
  </message>
  <message>
   <source>Picture on the field map</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Image sur la carte du terrain</translation>
  </message>
  <message>
   <source>Show the picture on the field map, as seen from above: lines that bend or miss the map's show where a camera is wrong</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Afficher l'image vue de dessus sur la carte du terrain : les lignes courbées ou décalées par rapport à celles de la carte montrent où une caméra est fausse</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bande d’images</translation>
  </message>
  <message>
   <source>Below the picture: thumbnails of the frames, or the timeline of a video</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Sous l’image : vignettes des images, ou la chronologie d’une vidéo</translation>
  </message>
  <message>
   <source>List of frames</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Liste des images</translation>
  </message>
  <message>
   <source>Show the frames with their names and a filter at the left, instead of the strip; once more closes the list</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Afficher à gauche les images avec leurs noms et un filtre, au lieu de la bande ; une fois de plus ferme la liste</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Erreurs et JaC de l’image ou du jeu, pour toutes les sources affichées</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Panneaux pour annoter</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Éléments, constats de la vérification, repères</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Panneaux pour juger</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Scores, sources de caméras, ajustement, graphiques</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Panneaux pour relire</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>État, commentaires et temps, un second annotateur</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Cacher tous les panneaux</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Donner toute la place à l’image</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Clavier vers les panneaux</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Dans l’image, Tab parcourt les fantômes ; ceci mène le clavier aux panneaux</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Clavier vers la partie suivante</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Image, panneaux, barres : le clavier en fait le tour</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Clavier vers la partie précédente</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Le même tour à l’envers</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Réinitialiser la disposition</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Remettre les panneaux où ils étaient au début</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Charger des caméras…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Juger un dossier de caméras ou d’homographies d’après les annotations</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Charger un fichier de caméra…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Juger un seul fichier de caméra, ou un zip de plusieurs</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Source de caméras suivante</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Juger avec la source chargée suivante</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Source de caméras précédente</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Juger avec la précédente</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Échanger avec la source comparée</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Juger avec la source comparée, et comparer avec celle-ci (ou taper la virgule ; la tenir pour voir seulement)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Tracer les autres sources</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes, with the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Tracer les sources cochées du panneau Caméras en fil de fer à côté de l’active</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Vue partagée</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Tracer la source active à gauche d’une séparation, la source comparée à droite</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>À combien de mètres l’une de l’autre, au sol, la source active et la source comparée voient chaque pixel</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Carte d’incertitude</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Où sur le terrain la caméra ajustée est bonne à 0.1, 0.5 et 1 m</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajustement continu</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajuster une caméra aux clics de l’image après chaque modification</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Enregistrer l’ajustement comme caméra de l’image</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Écrire la caméra ajustée aux clics dans le dossier cameras/fitted du jeu de données</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Dimensions du terrain…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Longueur et largeur du terrain de ce stade, saisies ou trouvées d’après toutes les images ; et où sur ses lignes sont les clics</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Seuil : 0.5 px de plus</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Permettre de plus grandes distances</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Seuil : 0.5 px de moins</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Ne permettre que de plus petites distances</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>L’évaluation officielle SoccerNet, bizarreries comprises</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>La définition de l’article, sans les artefacts du code officiel</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Éléments hors du sol</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Compter comme manqués</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Les buts, paniers et filets qu’une homographie ne peut pas projeter comptent contre elle</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Les buts, paniers et filets qu’une homographie ne peut pas projeter ne sont pas comptés</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Caméra fausse</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>La caméra active est fausse sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Annotation fausse</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Les clics sont faux sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>OK</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Caméra et clics sont justes sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Note sur le verdict…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Dire en quelques mots ce qui est faux ; c’est exporté avec le verdict</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Arrêter de noter le jeu</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Arrêter de calculer le JaC des images pas encore ouvertes et de comparer les sources</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Rechercher…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>La palette de commandes : toute action, tout élément, image, source de caméras et dossier récent, par quelques lettres de son nom</translation>
  </message>
  <message>
   <source>Draw, accept, check, judge and export, step by step, on a copy of the sample</source>
   <extracomment>[the action tour]</extracomment>
   <translation>Dessiner, accepter, vérifier, juger et exporter, pas à pas, sur une copie de l’exemple</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Montrer toutes les actions et leurs touches sur une feuille</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Donner d’autres touches aux actions et aux éléments, ou prendre celles d’un autre programme</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>Le guide fourni avec le programme ; il n’a pas besoin du réseau</translation>
  </message>
  <message>
   <source>Copy details of the last error</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Copier les détails de la dernière erreur</translation>
  </message>
  <message>
   <source>What an unexpected error left in the log, for a report to the maintainers</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Ce qu’une erreur inattendue a laissé dans le journal, pour un rapport aux mainteneurs</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Version</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Apparence</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Thème</translation>
  </message>
  <message>
   <source>Light, dark or system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Clair, sombre ou comme le système</translation>
  </message>
  <message>
   <source>System</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Système</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Clair</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Sombre</translation>
  </message>
  <message>
   <source>Text size</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Taille du texte</translation>
  </message>
  <message>
   <source>Text size, % of system (after restart)</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Taille du texte, % de celle du système (après redémarrage)</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Langue</translation>
  </message>
  <message>
   <source>Language of the window (after restart); files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Langue de la fenêtre (après redémarrage) ; les fichiers restent ce qu’ils sont</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Ce que disent les couleurs sur l’image</translation>
  </message>
  <message>
   <source>Author name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Nom de l’auteur</translation>
  </message>
  <message>
   <source>Author name (empty = login name)</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Nom de l’auteur (vide = nom de session)</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Jugement</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Seuil</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>À quelle distance de son élément un point annoté peut être, en px de la taille d’évaluation</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Comment les caméras sont jugées : comme l’évaluation officielle, bizarreries comprises, ou selon la définition de l’article</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (article)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Comment comptent les éléments qu’une homographie ne peut pas projeter : buts, paniers, filets</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modèle de l’ajustement continu</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>La caméra ajustée aux clics ; auto : la plus simple qu’ils permettent</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Juger l’ajustement</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Si l’ajustement est jugé là où il n’y a rien d’autre</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Part visible pour tout accepter</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Quelle part de la ligne d’un fantôme doit se voir pour l’accepter avec tous les autres</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Football américain (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de touche proche</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de touche lointaine</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks proches</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks lointaines</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Ligne de but gauche</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 5 yards gauche</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 10 yards gauche</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 15 yards gauche</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 20 yards gauche</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 25 yards gauche</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 30 yards gauche</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 35 yards gauche</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 40 yards gauche</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 45 yards gauche</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 50 yards</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Ligne de but droite</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 5 yards droite</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 10 yards droite</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 15 yards droite</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 20 yards droite</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 25 yards droite</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 30 yards droite</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 35 yards droite</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 40 yards droite</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 45 yards droite</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Barre transversale gauche</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But gauche, montant gauche</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But gauche, montant droit</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Barre transversale droite</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But droit, montant gauche</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But droit, montant droit</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai gauche</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai droite</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longueur avec les deux zones d’en-but</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Profondeur d’une zone d’en-but</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne de yard à la ligne de touche</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks à la ligne de touche</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai à la ligne de but</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longueur de la marque d’essai</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Largeur du but</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hauteur de la barre transversale</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Montants au-dessus de la barre</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Largeur des lignes</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Largeur de la ligne de but</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Largeur du bord</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Moitié gauche</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Moitié droite</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>But gauche</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>But droit</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Athlétisme (piste de 400 m)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordure</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloir 8, bord extérieur</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloir 9, bord extérieur</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne d’arrivée</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 110 m haies</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ des 3000 m et 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de rabattement</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne intérieure</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Longueur sur huit couloirs</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Largeur sur huit couloirs</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Largeur d’un couloir</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloirs</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Arrivée et départs</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Basketball (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne médiane</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Rond central</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche, côté lointain</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne de lancer franc gauche</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche, côté proche</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de lancer franc gauche</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite, côté lointain</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne de lancer franc droite</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite, côté proche</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de lancer franc droit</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arc à trois points gauche</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points gauche, droite lointaine</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points gauche, droite proche</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arc à trois points droit</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points droite, droite lointaine</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points droite, droite proche</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau gauche</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau gauche</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de non-charge gauche</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau droit</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau droit</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de non-charge droit</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectangle du panneau gauche</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centre de l’anneau gauche</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectangle du panneau droit</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centre de l’anneau droit</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Longueur</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Ligne médiane au-delà des touches</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Rayon du cercle</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Longueur de la raquette</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur de la raquette</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rayon à trois points</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points à la ligne de touche</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rayon de non-charge</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau à la ligne de fond</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur du panneau</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur du panneau</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Bord inférieur du panneau</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur du rectangle du panneau</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur du rectangle du panneau</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur de l’anneau</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rayon de l’anneau</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau au panneau</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points gauche</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points droite</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panier gauche</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panier droit</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Basketball (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Cercle de lancer franc gauche</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Cercle de lancer franc droit</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arc de zone restreinte gauche</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arc de zone restreinte droit</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rond central intérieur</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark lointaine gauche</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark lointaine droite</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark proche gauche</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark proche droite</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rayon du cercle intérieur</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rayon de la zone restreinte</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark à la ligne de fond</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Longueur d’une hash mark</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Futsal</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne de touche proche</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne de touche lointaine</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne médiane</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ligne de surface gauche</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ligne de surface droite</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But gauche, poteau lointain</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But gauche, poteau proche</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But droit, poteau lointain</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But droit, poteau proche</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point central</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty gauche</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty gauche</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty droit</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty droit</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin lointain gauche</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin proche gauche</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin lointain droit</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin proche droit</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, gauche extérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, gauche intérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, droite intérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, droite extérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, gauche extérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, gauche intérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, droite intérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, droite extérieure</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Largeur des poteaux</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rayon de la surface de réparation</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty à la ligne de but</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty à la ligne de but</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rayon du rond central</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rayon des arcs de coin</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Hauteur du but</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Surface de réparation gauche</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Surface de réparation droite</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Points</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Coins</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zones de remplacement</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Handball</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ligne latérale proche</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ligne latérale lointaine</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Zone d’engagement</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de surface de but gauche</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 7 mètres gauche</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 4 mètres gauche</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de surface de but droite</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 7 mètres droite</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 4 mètres droite</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement lointaine, gauche</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement lointaine, droite</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement proche, gauche</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement proche, droite</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rayon de la surface de but</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rayon de la ligne de jet franc</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Surface de but gauche</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Surface de but droite</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Lignes de changement</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Hockey sur glace (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande latérale proche</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande latérale lointaine</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande de fond gauche</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande de fond droite</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin proche gauche</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin lointain gauche</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin proche droit</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin lointain droit</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue gauche</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue droite</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle proche gauche</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle lointain gauche</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle proche droit</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle lointain droit</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone de but gauche</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But gauche, poteau gauche</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But gauche, poteau droit</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone de but droite</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But droit, poteau gauche</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But droit, poteau droit</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze gauche, côté proche</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze gauche, côté lointain</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze droit, côté proche</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze droit, côté lointain</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone des arbitres, proche</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone des arbitres, lointaine</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point central</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone proche gauche</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone lointain gauche</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone proche droit</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone lointain droit</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre proche gauche</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre lointain gauche</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre proche droit</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre lointain droit</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande proche</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande lointaine</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande gauche</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande droite</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin proche gauche</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin lointain gauche</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin proche droit</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin lointain droit</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon des coins</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Hauteur des bandes</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne de but à la bande de fond</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Ligne bleue à la bande de fond</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon des cercles d’engagement</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone à la ligne de but</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre à la ligne bleue</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point au grand axe</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon de la zone de but</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Largeur de la zone de but</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon de la zone des arbitres</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze à la ligne de but</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze à la bande de fond</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Largeur des lignes bleues et médiane</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bandes</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Lignes</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercles d’engagement</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Points d’engagement</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Haut des bandes</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Hockey sur glace (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue à la ligne de but</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Football</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, proche</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, avant</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, lointain</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, proche</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, avant</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, lointain</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Arc de surface gauche</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Arc de surface droit</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, proche</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, avant</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, lointain</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, proche</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, avant</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, lointain</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin lointain gauche (pied)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin proche gauche (pied)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin lointain droit (pied)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin proche droit (pied)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profondeur de la surface de réparation</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Largeur de la surface de réparation</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profondeur de la surface de but</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Largeur de la surface de but</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>But indéterminé</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Ligne indéterminée</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tennis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de double lointaine</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de double proche</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de simple lointaine</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de simple proche</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service gauche</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service droite</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne médiane de service</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Haut du filet</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet lointain</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet proche</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Sangle centrale du filet</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Piquet de simple lointain</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Piquet de simple proche</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marque centrale gauche</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marque centrale droite</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur du simple</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service au filet</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur de la ligne de fond</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur de la ligne médiane</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Longueur de la marque centrale</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet à la sangle</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet aux poteaux</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet aux piquets de simple</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet à la ligne latérale</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Carrés de service</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Filet</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Volleyball</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque gauche</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque droite</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Bande supérieure du filet</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Bande inférieure du filet</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne lointaine</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne proche</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau lointain</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau proche</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement lointain gauche</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement proche gauche</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement lointain droit</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement proche droit</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service lointaine gauche</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service proche gauche</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service lointaine droite</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service proche droite</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque à la ligne médiane</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur du filet</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur de la toile du filet</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longueur du filet</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne au-dessus du filet</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau à la ligne latérale</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur des poteaux</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement de la ligne d’attaque</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service à la ligne de fond</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longueur de la marque de service</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marques hors du terrain</translation>
  </message>
 </context>
</TS>
