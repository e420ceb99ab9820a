<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>the principal point is far from the centre of the picture, which seems cut out of a larger one</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>el punto principal está lejos del centro de la imagen, que parece recortada de otra mayor</translation>
  </message>
  <message>
   <source>with aspect ratio and principal point {px} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>con relación de aspecto y punto principal {px} px: no claramente mejor</translation>
  </message>
  <message>
   <source>coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>las coordenadas parecen píxeles, se esperaba de 0 a 1 (x = {x:g}, y = {y:g})</translation>
  </message>
  <message>
   <source>without lens distortion the points are {without} px off, with it {with_it} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>sin distorsión de lente los puntos están a {without} px, con ella a {with_it} px: no claramente mejor</translation>
  </message>
  <message>
   <source>aspect ratio and principal point bring the points from {before} to {after} px, more than three parameters would by chance</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>la relación de aspecto y el punto principal llevan los puntos de {before} a {after} px, más de lo que harían tres parámetros por azar</translation>
  </message>
  <message>
   <source>lens distortion brings the points from {before} to {after} px</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>la distorsión de lente lleva los puntos de {before} a {after} px</translation>
  </message>
  <message>
   <source>the points show lens distortion clearly and are {px} px off</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>los puntos muestran claramente distorsión de lente y están a {px} px</translation>
  </message>
  <message>
   <source>even with the position known: {why}</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>incluso con la posición conocida: {why}</translation>
  </message>
  <message>
   <source>{count} positions, and nothing tells which is its</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>{count} posiciones, y nada dice cuál es la suya</translation>
  </message>
  <message>
   <source>all labels fit with far and near exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>todas las clases encajan con lejos y cerca intercambiados</translation>
  </message>
  <message>
   <source>all labels fit with left and right exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>todas las clases encajan con izquierda y derecha intercambiadas</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, {before:.1f} px as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>los elementos están de media a {after:.1f} px, a {before:.1f} px tal como están</translation>
  </message>
  <message>
   <source>two points are exchanged: the one of {some} and the one of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>dos puntos están intercambiados: el de {some} y el de {others}</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, no camera fits the labels as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>los elementos están de media a {after:.1f} px, ninguna cámara encaja con las clases tal como están</translation>
  </message>
  <message>
   <source>{a} and {b} fit with each other's label</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} y {b} encajan con la clase del otro</translation>
  </message>
  <message>
   <source>{titles} fit with each other's labels</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} encajan con las clases de los otros</translation>
  </message>
  <message>
   <source>relabel {steps}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>cambiar la clase: {steps}</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} está hasta a {px:.0f} px de donde lo muestra la cámara de los demás</translation>
  </message>
  <message>
   <source>{title} is nowhere near where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} está lejos de donde lo muestra la cámara de los demás</translation>
  </message>
  <message>
   <source>without {titles} the others drop from {before:.1f} to {after:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>sin {titles} los demás bajan de {before:.1f} a {after:.1f} px</translation>
  </message>
  <message>
   <source>swap {a} and {b}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>intercambiar {a} y {b}</translation>
  </message>
  <message>
   <source>{a} to {b}</source>
   <comment>labels</comment>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} a {b}</translation>
  </message>
  <message>
   <source>it lies where {title} should be</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>está donde debería estar {title}</translation>
  </message>
  <message>
   <source>the others are {px:.1f} px off with and without it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>los demás están a {px:.1f} px con él y sin él</translation>
  </message>
  <message>
   <source>more than its own place is uncertain</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>más de lo que es incierto su propio lugar</translation>
  </message>
  <message>
   <source>relabel to {title}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>cambiar la clase a {title}</translation>
  </message>
  <message>
   <source>it lies on {title}, which is annotated as well</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>está sobre {title}, que también está anotado</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera shows it; too few elements fit to say which are wrong</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} está hasta a {px:.0f} px de donde lo muestra la cámara; encajan demasiado pocos elementos para decir cuáles están mal</translation>
  </message>
  <message>
   <source>no camera fits these labels together</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>ninguna cámara encaja con todas estas clases</translation>
  </message>
  <message>
   <source>exchange far and near in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>intercambiar lejos y cerca en toda la imagen</translation>
  </message>
  <message>
   <source>exchange left and right in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>intercambiar izquierda y derecha en toda la imagen</translation>
  </message>
  <message>
   <source>turn the labels by half a turn</source>
   <extracomment>[procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>girar las clases media vuelta</translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn</source>
   <extracomment>the camera stands on a side of the field where hardly any other of {n} frame does: a camera of its own, or labels turned by half a turn / the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>la cámara está en un lado del campo en que casi ninguna otra de {n} imagen lo está: una cámara aparte, o clases giradas media vuelta</numerusform>
    <numerusform>la cámara está en un lado del campo en que casi ninguna otra de {n} imágenes lo está: una cámara aparte, o clases giradas media vuelta</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does</source>
   <extracomment>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frame does / the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>la cámara está al otro lado del campo que el resto; con sus clases giradas media vuelta está donde la de {n} imagen</numerusform>
    <numerusform>la cámara está al otro lado del campo que el resto; con sus clases giradas media vuelta está donde la de {n} imágenes</numerusform>
   </translation>
  </message>
  <message>
   <source>no such class: {name!r}, did you mean {title}?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>no existe esa clase: {name!r}, ¿quiso decir {title}?</translation>
  </message>
  <message>
   <source>{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more than any lens bends it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} es recto en el campo, sus puntos se apartan hasta {px:.0f} px de una recta, más de lo que la curva cualquier lente</translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points, a line takes two</source>
   <extracomment>{title} has {n} point, a line takes two / {title} has {n} points, a line takes two [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} tiene {n} punto, una línea necesita dos</numerusform>
    <numerusform>{title} tiene {n} puntos, una línea necesita dos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points; a curve takes at least {least}</source>
   <extracomment>{title} has {n} point; a curve takes at least {least} / {title} has {n} points; a curve takes at least {least} [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} tiene {n} punto; una curva necesita al menos {least}</numerusform>
    <numerusform>{title} tiene {n} puntos; una curva necesita al menos {least}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points: {least} points needed for a curve</source>
   <extracomment>{title} has {n} point: {least} points needed for a curve / {title} has {n} points: {least} points needed for a curve [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} tiene {n} punto: una curva necesita {least}</numerusform>
    <numerusform>{title} tiene {n} puntos: una curva necesita {least}</numerusform>
   </translation>
  </message>
  <message>
   <source>{title} is a single place, it has {count} points up to {px:.0f} px apart</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} es un solo lugar, tiene {count} puntos separados hasta {px:.0f} px</translation>
  </message>
  <message>
   <source>the points of {title} go back and forth instead of along it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>los puntos de {title} van y vienen en vez de seguirlo</translation>
  </message>
  <message>
   <source>no such class: {name!r} fits no camera, and counts as missed where it is scored</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>no existe esa clase: {name!r} no encaja con ninguna cámara y cuenta como fallada donde se puntúa</translation>
  </message>
  <message>
   <source>{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two names?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{a} y {b} están uno sobre otro, a menos de {px:.0f} px: ¿una línea con dos nombres?</translation>
  </message>
  <message>
   <source>remove point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>quitar el punto {number}</translation>
  </message>
  <message>
   <source>look at point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>mirar el punto {number}</translation>
  </message>
  <message>
   <source>the points of {title} go over the same stretch more than once: their course is {times:.1f} times as long as it need be</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>los puntos de {title} pasan más de una vez por el mismo tramo: su recorrido es {times:.1f} veces más largo de lo necesario</translation>
  </message>
  <message>
   <source>That is annotated already</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>Eso ya está anotado</translation>
  </message>
  <message>
   <source>its corner</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>su esquina</translation>
  </message>
  <message>
   <source>the picture's edge</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>el borde de la imagen</translation>
  </message>
  <message>
   <source>move its points onto the line</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>poner sus puntos sobre la línea</translation>
  </message>
  <message>
   <source>{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} se curva: entre puntos, su línea se aparta hasta {px:.0f} px. Pulse R para seguirla</translation>
  </message>
  <message>
   <source>one end of {title} is {px:.0f} px off the line. Move it onto the paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>un extremo de {title} está a {px:.0f} px de la línea. Póngalo sobre la pintura</translation>
  </message>
  <message>
   <source>{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends? Press R</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>el {percent:.0f} % de {title} no está sobre pintura (hueco mayor: {px:.0f} px). ¿Se curva la línea? Pulse R</translation>
  </message>
  <message>
   <source>one end of {title} is not on paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>un extremo de {title} no está sobre pintura</translation>
  </message>
  <message>
   <source>{title} stops {px:.0f} px short of {what}</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>a {title} le faltan {px:.0f} px para llegar a {what}</translation>
  </message>
  <message>
   <source>look at it</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>mirarlo</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>el punto {number} de {title} está a {off:.0f} px, sus otros puntos a lo sumo a {rest:.1f} px</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>el punto {number} de {title} está a {off:.0f} px, su otro punto a lo sumo a {rest:.1f} px</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>todo está al revés: lejos y cerca están intercambiados</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>todo está al revés: izquierda y derecha están intercambiadas</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, or left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>todo está al revés: lejos y cerca, o izquierda y derecha, están intercambiados</translation>
  </message>
  <message>
   <source>{title} is on the wrong side of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{title} está en el lado equivocado de {others}</translation>
  </message>
  <message>
   <source>{titles} lie on each other's side of the elements around them</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} están cada uno en el lado del otro respecto a los elementos de alrededor</translation>
  </message>
  <message>
   <source>{titles} cannot lie this way round to each other, whatever the camera</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} no pueden estar así uno respecto al otro, sea cual sea la cámara</translation>
  </message>
  <message>
   <source>only {share:.0%} of the lines in sight are on paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py, procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>solo el {share:.0%} de las líneas a la vista está sobre pintura</translation>
  </message>
  <message>
   <source>there is too little paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>hay demasiado poca pintura</translation>
  </message>
  <message>
   <source>the paint nearby would take a peg from its place</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>la pintura cercana quitaría una estaca de su sitio</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line, and {more} more are off theirs</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} está a {px:.0f} px de su línea, y otros {more} también</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} está a {px:.0f} px de su línea</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, {needed} needed</source>
   <extracomment>{n} element, {needed} needed / {n} elements, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} elemento, se necesitan {needed}</numerusform>
    <numerusform>{n} elementos, se necesitan {needed}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{points} points on {n} elements, two different ones on each of {needed} needed</source>
   <extracomment>{points} points on {n} element, two different ones on each of {needed} needed / {points} points on {n} elements, two different ones on each of {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{points} puntos en {n} elemento, se necesitan dos distintos en cada uno de {needed}</numerusform>
    <numerusform>{points} puntos en {n} elementos, se necesitan dos distintos en cada uno de {needed}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} elements on the ground, {needed} needed</source>
   <extracomment>{n} element on the ground, {needed} needed / {n} elements on the ground, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} elemento en el suelo, se necesitan {needed}</numerusform>
    <numerusform>{n} elementos en el suelo, se necesitan {needed}</numerusform>
   </translation>
  </message>
  <message>
   <source>all points lie in one place of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>todos los puntos están en un mismo lugar de la imagen</translation>
  </message>
  <message>
   <source>all points lie on one line of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>todos los puntos están en una misma línea de la imagen</translation>
  </message>
  <message>
   <source>not a plausible pose: the fit did not settle</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: el ajuste no se estabilizó</translation>
  </message>
  <message>
   <source>not a plausible pose: on the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: en el suelo</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.1f} m below the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: {metres:.1f} m bajo el suelo</translation>
  </message>
  <message>
   <source>not a plausible pose: only {metres:.1f} m above the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: solo {metres:.1f} m sobre el suelo</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.0f} m from the field's centre</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: a {metres:.0f} m del centro del campo</translation>
  </message>
  <message>
   <source>not a plausible pose: rolled by {degrees:.0f} degrees</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: alabeo de {degrees:.0f} grados</translation>
  </message>
  <message>
   <source>not a plausible pose: focal length {px:.0f} px at 960 px width</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>pose no plausible: distancia focal {px:.0f} px a 960 px de ancho</translation>
  </message>
  <message>
   <source>pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>giro, inclinación o alabeo ± más de {degrees:g}°, posición ± más del {way:g} % del camino al centro del campo, o distancia focal ± más del {focal:g} %, o clics que son iguales desde el otro extremo</translation>
  </message>
  <message>
   <source>no camera explains these elements together: the best one misses half of them by more than {px:.0f} px (are the labels right?)</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>ninguna cámara explica estos elementos juntos: la mejor falla la mitad por más de {px:.0f} px (¿son correctas las clases?)</translation>
  </message>
  <message>
   <source>pan ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>giro ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>tilt ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>inclinación ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>roll ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>alabeo ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>position ± {metres:.0f} m</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>posición ± {metres:.0f} m</translation>
  </message>
  <message>
   <source>focal length ± {percent:.0f} %</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>distancia focal ± {percent:.0f} %</translation>
  </message>
  <message>
   <source>the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>igual desde el otro extremo</translation>
  </message>
  <message>
   <source>a different view fits almost as well</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>otra vista encaja casi igual de bien</translation>
  </message>
  <message>
   <source>expected lines are missing</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>faltan líneas esperadas</translation>
  </message>
  <message>
   <source>some lines in the picture do not match the field</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>algunas líneas de la imagen no corresponden al campo</translation>
  </message>
  <message>
   <source>too few lines in view</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>se ven demasiado pocas líneas</translation>
  </message>
  <message>
   <source>unusual camera position</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>posición de cámara inusual</translation>
  </message>
  <message>
   <source>the visible lines do not determine the camera</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>las líneas visibles no determinan la cámara</translation>
  </message>
  <message>
   <source>{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>hallado el {lines:.0f} % de las líneas esperadas, explicado el {paint:.0f} % de la pintura visible</translation>
  </message>
  <message>
   <source>is this {field}? {why}</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>¿es esto {field}? {why}</translation>
  </message>
  <message>
   <source>no camera fits the lines (best: {shares})</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>ninguna cámara encaja con las líneas (la mejor: {shares})</translation>
  </message>
  <message>
   <source>the picture is nearly square: its pixels may not be</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>la imagen es casi cuadrada: sus píxeles quizá no lo sean</translation>
  </message>
  <message>
   <source>{field} has no painted lines to look for</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{field} no tiene líneas pintadas que buscar</translation>
  </message>
  <message>
   <source>no camera has its lines on the paint of this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>ninguna cámara tiene sus líneas sobre la pintura de esta imagen</translation>
  </message>
  <message>
   <source>there is hardly any paint on the ground in this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>apenas hay pintura en el suelo en esta imagen</translation>
  </message>
  <message>
   <source>too little paint in sight</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>demasiado poca pintura a la vista</translation>
  </message>
  <message>
   <source>too little of what should be in sight was found</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>se halló demasiado poco de lo que debería verse</translation>
  </message>
  <message>
   <source>the paint that was found would move the camera too far</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>la pintura hallada movería demasiado la cámara</translation>
  </message>
  <message>
   <source>the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>los píxeles quizá no sean {aspect:.3f} veces más anchos que altos ({percent:.0f} %)</translation>
  </message>
  <message>
   <source>the track is {px:.0f} px off the nearest frame whose camera was known</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>el seguimiento se aparta {px:.0f} px de la imagen más cercana cuya cámara se conocía</translation>
  </message>
  <message>
   <source>{count} of {total} clicks lie where the camera shows nothing</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>{count} de {total} clics están donde la cámara no muestra nada</translation>
  </message>
  <message>
   <source>the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least {least:g} are needed)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>las vistas lo miran casi desde la misma dirección (separadas {degrees:.2f} grados, se necesitan al menos {least:g})</translation>
  </message>
  <message>
   <source>clicked in no view that has a camera</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>no marcado en ninguna vista con cámara</translation>
  </message>
  <message>
   <source>cameras that know only the ground (homographies) have no position in space</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>las cámaras que solo conocen el suelo (homografías) no dan ningún lugar en el espacio</translation>
  </message>
  <message>
   <source>the lines of sight meet behind the camera of {names}</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>las líneas de visión se cruzan detrás de la cámara de {names}</translation>
  </message>
  <message>
   <source>clicked in one view only</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>marcado en una sola vista</translation>
  </message>
  <message>
   <source>would be farther than {metres:g} m from the field</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>estaría a más de {metres:g} m del campo</translation>
  </message>
  <message>
   <source>the views do not agree: {far} px off (is it the same place in all of them, and are the cameras right?)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>las vistas no concuerdan: {far} px (¿es el mismo lugar en todas, y son correctas las cámaras?)</translation>
  </message>
  <message>
   <source>Fitted to the clicks of each frame; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>Ajustada a los clics de cada imagen; nada de ello está en un archivo</translation>
  </message>
  <message>
   <source>the paint is {px:.1f} px from the lines</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>la pintura está a {px:.1f} px de las líneas</translation>
  </message>
  <message>
   <source>Followed through the shot; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>Seguida a lo largo del plano; nada de ello está en un archivo</translation>
  </message>
  <message>
   <source>no track here: {why}</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>aquí no hay seguimiento: {why}</translation>
  </message>
  <message>
   <source>no fit of {frame} yet</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>aún no hay ajuste de {frame}</translation>
  </message>
  <message>
   <source>no camera was found</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py, procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>no se halló ninguna cámara</translation>
  </message>
  <message>
   <source>carried over by the picture's motion, not measured on paint</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>llevada por el movimiento de la imagen, no medida sobre pintura</translation>
  </message>
  <message>
   <source>not followed so far</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>no seguida hasta ahora</translation>
  </message>
  <message>
   <source>{title} was surveyed: its position stays as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} se midió en el terreno: su posición queda como está</translation>
  </message>
  <message>
   <source>{title} moves: its positions hold for an instant each</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} se mueve: cada una de sus posiciones vale para un instante</translation>
  </message>
  <message>
   <source>its camera is hardly determined: {what}</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>su cámara está apenas determinada: {what}</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why}), and {count} more</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>sin cámara en {frame} ({why}), y {count} más</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why})</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>sin cámara en {frame} ({why})</translation>
  </message>
  <message>
   <source>surveyed: kept as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>medida en el terreno: queda como está</translation>
  </message>
  <message>
   <source>untouched</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>sin tocar</translation>
  </message>
  <message>
   <source>in progress</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>en curso</translation>
  </message>
  <message>
   <source>done</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>terminada</translation>
  </message>
  <message>
   <source>approved</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>aprobada</translation>
  </message>
  <message>
   <source>rejected</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>rechazada</translation>
  </message>
  <message>
   <source>clicked</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>marcados</translation>
  </message>
  <message>
   <source>snapped</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>ajustados a línea</translation>
  </message>
  <message>
   <source>regularised</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>regularizados</translation>
  </message>
  <message>
   <source>copied</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>copiados</translation>
  </message>
  <message>
   <source>moved</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>movidos</translation>
  </message>
  <message>
   <source>accepted suggestion</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>sugerencias aceptadas</translation>
  </message>
  <message>
   <source>proposed</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>propuestos</translation>
  </message>
  <message>
   <source>accepted proposal</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>propuestas aceptadas</translation>
  </message>
  <message>
   <source>unconfirmed by paint</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>sin confirmar por la pintura</translation>
  </message>
  <message>
   <source>from the file</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>del archivo</translation>
  </message>
  <message>
   <source>camera</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>cámara</translation>
  </message>
  <message>
   <source>annotation</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>anotación</translation>
  </message>
  <message>
   <source>fine</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>correcto</translation>
  </message>
  <message>
   <source>camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>cámara errónea</translation>
  </message>
  <message>
   <source>labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>anotación errónea</translation>
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
   <translation>retirado</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>guardado</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/dataset/workspace.py]</extracomment>
   <translation>como se encontró</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>lo que se guardó en otra parte</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>sobrescrito</translation>
  </message>
  <message>
   <source>fitted on these clicks</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustada a estos clics</translation>
  </message>
  <message>
   <source>fitted to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustada a otra versión de estas anotaciones</translation>
  </message>
  <message>
   <source>fitted on these clicks, or to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>ajustada a estos clics o a otra versión de estas anotaciones</translation>
  </message>
  <message>
   <source>closer to these clicks than a prediction can be</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>más cerca de estos clics de lo que puede estar una predicción</translation>
  </message>
  <message>
   <source>by file type and content</source>
   <extracomment>[procc_annotator/formats/cameras/registry.py]</extracomment>
   <translation>según el tipo y el contenido del archivo</translation>
  </message>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Archivo</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Editar</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Elemento</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, the menus]</extracomment>
   <translation>Ver</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/command_palette.py, the menus]</extracomment>
   <translation>Cámara</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Ayuda</translation>
  </message>
  <message>
   <source>The picture cannot be shown</source>
   <extracomment>[procc_annotator/gui/canvas/annotation_preview.py]</extracomment>
   <translation>La imagen no se puede mostrar</translation>
  </message>
  <message>
   <source>no camera is known here that could be dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>aquí no se conoce ninguna cámara que arrastrar</translation>
  </message>
  <message>
   <source>taken back: the camera is as before it was dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>retirado: la cámara está como antes de arrastrarla</translation>
  </message>
  <message>
   <source>overlays are hidden (Ctrl+H)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>las superposiciones están ocultas (Ctrl+H)</translation>
  </message>
  <message>
   <source>a homography cannot be turned: choose another model (panel Fit)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>una homografía no se puede girar: elija otro modelo (panel Ajuste)</translation>
  </message>
  <message>
   <source>release leaves it here</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>al soltar queda aquí</translation>
  </message>
  <message>
   <source>Esc puts it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py, procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc lo devuelve</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs hold the camera</source>
   <extracomment>{n} peg holds the camera / {n} pegs hold the camera [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>{n} estaca sujeta la cámara</numerusform>
    <numerusform>{n} estacas sujetan la cámara</numerusform>
   </translation>
  </message>
  <message>
   <source>CAMERA</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>CÁMARA</translation>
  </message>
  <message numerus="yes">
   <source>peg taken away: {n} pegs left</source>
   <extracomment>peg taken away: {n} peg left / peg taken away: {n} pegs left [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>estaca quitada: queda {n} estaca</numerusform>
    <numerusform>estaca quitada: quedan {n} estacas</numerusform>
   </translation>
  </message>
  <message>
   <source>peg taken away: the camera is as it was found</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>estaca quitada: la cámara está como se halló</translation>
  </message>
  <message>
   <source>peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>estaca</translation>
  </message>
  <message>
   <source>press on a line of the wireframe</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>pulse sobre una línea del armazón</translation>
  </message>
  <message>
   <source>drag moves this peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>arrastrar mueve esta estaca</translation>
  </message>
  <message>
   <source>click takes it away</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>un clic la quita</translation>
  </message>
  <message>
   <source>drag a place of the wireframe to where it belongs</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>arrastre un punto del armazón a donde debe estar</translation>
  </message>
  <message>
   <source>drag {title} to where it belongs: the camera follows</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>arrastre {title} a donde debe estar: la cámara sigue</translation>
  </message>
  <message>
   <source>Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Ctrl+Z lo retira</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py, procc_annotator/gui/settings.py, procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>PAN</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>DESPLAZAR</translation>
  </message>
  <message>
   <source>drag moves the picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>arrastrar mueve la imagen</translation>
  </message>
  <message>
   <source>Esc takes the tool again</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Esc vuelve a la herramienta</translation>
  </message>
  <message>
   <source>load a second set of cameras to blink between two (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>cargue un segundo conjunto de cámaras para alternar entre dos (Ctrl+L)</translation>
  </message>
  <message>
   <source>crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks, Esc puts it away</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>retícula: las flechas la mueven (Mayús 0.1 px, Ctrl 10 px, Ctrl+Mayús 100 px), Espacio hace clic, Esc la guarda</translation>
  </message>
  <message>
   <source>point at a line first: with the mouse, or with the arrows</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>señale primero una línea: con el ratón o con las flechas</translation>
  </message>
  <message>
   <source>there is no line here to put a point on</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>aquí no hay ninguna línea en que poner un punto</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>cámara ilegible</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>aquí no hay cámara</translation>
  </message>
  <message>
   <source>next: {title}</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>siguiente: {title}</translation>
  </message>
  <message>
   <source>{title}  ±{sd:.1f} px  unsure</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>{title}  ±{sd:.1f} px  inseguro</translation>
  </message>
  <message>
   <source>{title} has no points in this frame: choose the element to delete</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} no tiene puntos en esta imagen: elija el elemento que borrar</translation>
  </message>
  <message>
   <source>choose the element to delete first: field map, list, or its key</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>elija primero el elemento que borrar: mapa del campo, lista o su tecla</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} points of {title}</source>
   <extracomment>dropped {n} point of {title} / dropped {n} points of {title} [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{n} punto de {title} descartado</numerusform>
    <numerusform>{n} puntos de {title} descartados</numerusform>
   </translation>
  </message>
  <message>
   <source>{titles}: changed elsewhere, look again first</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{titles}: cambiado en otra parte, mire de nuevo primero</translation>
  </message>
  <message numerus="yes">
   <source>kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on</source>
   <extracomment>kept {n} click of {title} on {frame}, unfinished: choose it there to go on / kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>se conserva {n} clic de {title} en {frame}, sin terminar: elíjalo allí para continuar</numerusform>
    <numerusform>se conservan {n} clics de {title} en {frame}, sin terminar: elíjalo allí para continuar</numerusform>
   </translation>
  </message>
  <message>
   <source>finished {title}</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} terminado</translation>
  </message>
  <message>
   <source>How good the fitted camera is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Cómo de buena es la cámara ajustada</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>metros en el suelo, 1 σ</translation>
  </message>
  <message>
   <source>How good the fitted camera ({model}) is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Cómo de buena es la cámara ajustada ({model})</translation>
  </message>
  <message>
   <source>{metres:g} m, asked of offside technology</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m, lo que se pide a la tecnología de fuera de juego</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd, median {median:.2f}</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>metros en el suelo, 1 σ, mediana {median:.2f}</translation>
  </message>
  <message>
   <source>metres on the ground</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>metros en el suelo</translation>
  </message>
  <message>
   <source>{metres:g} m: {percent:.0f} % of the field in sight</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m: {percent:.0f} % del campo a la vista</translation>
  </message>
  <message>
   <source>Blind: no camera is shown before Ctrl+Enter</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Ciego: no se muestra ninguna cámara antes de Ctrl+Intro</translation>
  </message>
  <message>
   <source>Blind mode, this frame is committed</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Modo ciego, esta imagen está entregada</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs</source>
   <extracomment>{n} peg / {n} pegs [procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>
    <numerusform>{n} estaca</numerusform>
    <numerusform>{n} estacas</numerusform>
   </translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara arrastrada, {pegs}, afinada con la pintura: {share:.0%} de sus líneas</translation>
  </message>
  <message>
   <source>Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara hallada, insegura: {why}. Mayús+Intro la acepta, Supr la rechaza</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, not made exact: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara arrastrada, {pegs}, sin afinar: {why}</translation>
  </message>
  <message>
   <source>Drag to move the divider (arrow keys do it too)</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Arrastre para mover el divisor (también con las flechas)</translation>
  </message>
  <message>
   <source>Divider of the split view</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Divisor de la vista dividida</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara arrastrada, {pegs}</translation>
  </message>
  <message>
   <source>Camera of the track: Shift+Enter accepts its elements</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara del seguimiento: Mayús+Intro acepta sus elementos</translation>
  </message>
  <message>
   <source>Looking for the camera in the picture …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Buscando la cámara en la imagen …</translation>
  </message>
  <message>
   <source>No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport? Click here</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>No se halló cámara: {why}. Para empezar, {advice} (Intro toma el primero). ¿Otro deporte? Haga clic aquí</translation>
  </message>
  <message>
   <source>Camera found, sure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara hallada, segura: {why}</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}: its lines are looked for …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara arrastrada, {pegs}: se buscan sus líneas …</translation>
  </message>
  <message>
   <source>Camera of the track, unsure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Cámara del seguimiento, insegura: {why}</translation>
  </message>
  <message>
   <source>nothing changed: regular already, or no painted line was found there</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>nada cambió: ya era regular, o no se halló allí ninguna línea pintada</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, along the track; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copiado de {frame}, según el seguimiento; Mayús+V confirma todos</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, moved with the camera; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copiado de {frame}, movido con la cámara; Mayús+V confirma todos</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, as they were: no motion found; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} copiado de {frame}, tal como estaba: no se halló movimiento; Mayús+V confirma todos</translation>
  </message>
  <message>
   <source>taken back: nothing is regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>retirado: no se regulariza nada</translation>
  </message>
  <message>
   <source>taken back: nothing is copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>retirado: no se copia nada</translation>
  </message>
  <message>
   <source>the frame was left: nothing was regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>se dejó la imagen: no se regularizó nada</translation>
  </message>
  <message>
   <source>the frame was left: nothing was copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>se dejó la imagen: no se copió nada</translation>
  </message>
  <message numerus="yes">
   <source>{n} points unconfirmed by paint</source>
   <extracomment>{n} point unconfirmed by paint / {n} points unconfirmed by paint [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{n} punto sin confirmar por la pintura</numerusform>
    <numerusform>{n} puntos sin confirmar por la pintura</numerusform>
   </translation>
  </message>
  <message>
   <source>regularise {what}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>regularizar {what}</translation>
  </message>
  <message>
   <source>copy from {frame}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>copiar de {frame}</translation>
  </message>
  <message>
   <source>left out, not in the picture or no line seen: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>omitidos, fuera de la imagen o sin línea visible: {elements}</translation>
  </message>
  <message>
   <source>choose an annotated element first</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>elija primero un elemento anotado</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements</source>
   <extracomment>{n} element / {n} elements [procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>
    <numerusform>{n} elemento</numerusform>
    <numerusform>{n} elementos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>regularised {what}: {n} points</source>
   <extracomment>regularised {what}: {n} point / regularised {what}: {n} points [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{what} regularizado: {n} punto</numerusform>
    <numerusform>{what} regularizado: {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} has corners or is one place: it stays as it is</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{element} tiene esquinas o es un solo lugar: queda como está</translation>
  </message>
  <message>
   <source>no element of the field is annotated here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>aquí no hay anotado ningún elemento del campo</translation>
  </message>
  <message>
   <source>no frame before this one is annotated</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>ninguna imagen antes de esta está anotada</translation>
  </message>
  <message>
   <source>{frame} has no element that is missing here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} no tiene ningún elemento que falte aquí</translation>
  </message>
  <message>
   <source>{element} becomes {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} pasa a {other}</translation>
  </message>
  <message>
   <source>duplicate {element} as {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>duplicar {element} como {other}</translation>
  </message>
  <message>
   <source>merge {element} into {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>unir {element} con {other}</translation>
  </message>
  <message>
   <source>close gaps</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>cerrar huecos</translation>
  </message>
  <message numerus="yes">
   <source>confirm {n} elements</source>
   <extracomment>confirm {n} element / confirm {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>confirmar {n} elemento</numerusform>
    <numerusform>confirmar {n} elementos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>drop {n} unconfirmed elements</source>
   <extracomment>drop {n} unconfirmed element / drop {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>descartar {n} elemento sin confirmar</numerusform>
    <numerusform>descartar {n} elementos sin confirmar</numerusform>
   </translation>
  </message>
  <message>
   <source>Name of the line</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Nombre de la línea</translation>
  </message>
  <message>
   <source>What is this line?</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>¿Qué línea es esta?</translation>
  </message>
  <message>
   <source>{element} is a curve, which two points do not show: click on</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} es una curva, que dos puntos no muestran: siga haciendo clic</translation>
  </message>
  <message>
   <source>swap {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>intercambiar {element} y {other}</translation>
  </message>
  <message>
   <source>{element} is its own symmetric element</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} es su propia clase simétrica</translation>
  </message>
  <message numerus="yes">
   <source>{elements} are annotated already</source>
   <extracomment>{elements} is annotated already / {elements} are annotated already [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{elements} ya está anotado</numerusform>
    <numerusform>{elements} ya están anotados</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} lies where {other} is: drag it to its place</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} está donde {other}: arrástrelo a su sitio</translation>
  </message>
  <message>
   <source>reverse {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>invertir {element}</translation>
  </message>
  <message>
   <source>choose the point to split at first (edit mode)</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>elija primero el punto por el que dividir (modo editar)</translation>
  </message>
  <message>
   <source>split {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>dividir {element}</translation>
  </message>
  <message numerus="yes">
   <source>confirmed {n} elements</source>
   <extracomment>confirmed {n} element / confirmed {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} elemento confirmado</numerusform>
    <numerusform>{n} elementos confirmados</numerusform>
   </translation>
  </message>
  <message>
   <source>nothing is unconfirmed on this frame</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>no hay nada sin confirmar en esta imagen</translation>
  </message>
  <message>
   <source>{element} is annotated already</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} ya está anotado</translation>
  </message>
  <message>
   <source>no end is that near to a corner or the picture's edge</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>ningún extremo está tan cerca de una esquina o del borde de la imagen</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} unconfirmed elements</source>
   <extracomment>dropped {n} unconfirmed element / dropped {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} elemento sin confirmar descartado</numerusform>
    <numerusform>{n} elementos sin confirmar descartados</numerusform>
   </translation>
  </message>
  <message>
   <source>Another element…</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Otro elemento…</translation>
  </message>
  <message>
   <source>Leave it unnamed</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Dejarla sin nombre</translation>
  </message>
  <message>
   <source>an element is split at a point between its ends, into a class that is free</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>un elemento se divide por un punto entre sus extremos, en una clase libre</translation>
  </message>
  <message>
   <source>{element} was changed elsewhere: look at it again</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} se cambió en otra parte: mírelo de nuevo</translation>
  </message>
  <message>
   <source>? (stays as it is, an unknown class)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>? (queda como está, una clase desconocida)</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Dejar fuera</translation>
  </message>
  <message>
   <source>Label</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Etiqueta</translation>
  </message>
  <message>
   <source>Shapes</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Formas</translation>
  </message>
  <message>
   <source>Stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Significa</translation>
  </message>
  <message>
   <source>Why</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Por qué</translation>
  </message>
  <message>
   <source>sure</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>seguro</translation>
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
   <translation>por decir</translation>
  </message>
  <message numerus="yes">
   <source>{n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on.</source>
   <extracomment>{n} label is no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. / {n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. [procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>
    <numerusform>{n} etiqueta no es ninguna clase de {field}. Diga qué significa; lo propuesto se dedujo de sus palabras y de los elementos sobre los que están sus formas.</numerusform>
    <numerusform>{n} etiquetas no son ninguna clase de {field}. Diga qué significan; lo propuesto se dedujo de sus palabras y de los elementos sobre los que están sus formas.</numerusform>
   </translation>
  </message>
  <message>
   <source>These names are more like those of {field}: choose that field first (File &gt; Field).</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Estos nombres se parecen más a los de {field}: elija primero ese campo (Archivo &gt; Campo).</translation>
  </message>
  <message>
   <source>Names of another program</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Nombres de otro programa</translation>
  </message>
  <message>
   <source>Keep these names with the dataset ({file})</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Conservar estos nombres con el conjunto ({file})</translation>
  </message>
  <message>
   <source>Import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importar</translation>
  </message>
  <message>
   <source>What {label} stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Qué significa {label}</translation>
  </message>
  <message>
   <source>What came of it</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Qué resultó</translation>
  </message>
  <message>
   <source>Import annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importar anotaciones</translation>
  </message>
  <message>
   <source>Annotations to import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Anotaciones que importar</translation>
  </message>
  <message>
   <source>Look into the files</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Mirar en los archivos</translation>
  </message>
  <message>
   <source>Only frames without annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Solo imágenes en que aún no hay nada anotado</translation>
  </message>
  <message>
   <source>Replace what is annotated in the others, too</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Reemplazar también lo anotado en las demás</translation>
  </message>
  <message>
   <source>What was there stays among the earlier versions of its frame, and undo brings it back</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Lo que había queda entre las versiones anteriores de la imagen, y deshacer lo devuelve</translation>
  </message>
  <message>
   <source>Annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Anotaciones</translation>
  </message>
  <message>
   <source>Format</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Formato</translation>
  </message>
  <message>
   <source>Import into</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importar en</translation>
  </message>
  <message>
   <source>Annotations (*.json *.xml *.zip);;All files (*)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Anotaciones (*.json *.xml *.zip);;Todos los archivos (*)</translation>
  </message>
  <message>
   <source>Export as</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Exportar como</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Exportar…</translation>
  </message>
  <message>
   <source>One zip archive instead of a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Un archivo zip en lugar de una carpeta</translation>
  </message>
  <message>
   <source>Replace files that are there</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Reemplazar los archivos existentes</translation>
  </message>
  <message>
   <source>Keep elements that SoccerNet has no class for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Conservar elementos para los que SoccerNet no tiene clase</translation>
  </message>
  <message>
   <source>Width of the lines</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Anchura de las líneas</translation>
  </message>
  <message>
   <source>Copy the pictures as well</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Copiar también las imágenes</translation>
  </message>
  <message>
   <source>Export to a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Exportar a una carpeta</translation>
  </message>
  <message>
   <source>Keeps {holds}.
Loses {loses}.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Conserva {holds}.
Pierde {loses}.</translation>
  </message>
  <message>
   <source>Add these names to the dataset's {file}, written anew</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Añadir estos nombres a {file} del conjunto, escrito de nuevo</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/messages.py]</extracomment>
   <translation>Cancelar</translation>
  </message>
  <message>
   <source>Close</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Cerrar</translation>
  </message>
  <message>
   <source>A folder, a zip archive, or one file</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Una carpeta, un archivo zip o un solo archivo</translation>
  </message>
  <message>
   <source>File…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Archivo…</translation>
  </message>
  <message>
   <source>Folder…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Carpeta…</translation>
  </message>
  <message>
   <source>Frames are matched by the name of their picture.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Las imágenes se emparejan por el nombre de su archivo.</translation>
  </message>
  <message>
   <source>Zip archive (*.zip)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Archivo zip (*.zip)</translation>
  </message>
  <message>
   <source>{frames}, {elements} and {points} written to {path} ({format}).</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frames}, {elements} y {points} escritos en {path} ({format}).</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} annotations</source>
   <extracomment>{n:,} annotation / {n:,} annotations [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} anotación</numerusform>
    <numerusform>{n:,} anotaciones</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>JaC of {n:,} frames</source>
   <extracomment>JaC of {n:,} frame / JaC of {n:,} frames [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>JaC de {n:,} imagen</numerusform>
    <numerusform>JaC de {n:,} imágenes</numerusform>
   </translation>
  </message>
  <message>
   <source>Not everything could be saved: what is on disk goes.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>No se pudo guardar todo: vale lo que hay en disco.</translation>
  </message>
  <message>
   <source>Nothing was written: no frame is annotated, or none could be written.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>No se escribió nada: ninguna imagen está anotada, o ninguna se pudo escribir.</translation>
  </message>
  <message>
   <source>the fit of {frame} is saved as {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>el ajuste de {frame} está guardado como {path}</translation>
  </message>
  <message>
   <source>{source} is made from the clicks it would be scored against: judge the cameras to be scored (procc-annotator calibrate fits and scores a set)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{source} se hace con los clics con que se puntuaría: juzgue las cámaras que puntuar (procc-annotator calibrate ajusta y puntúa un conjunto)</translation>
  </message>
  <message>
   <source>{annotations} and {scores}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{annotations} y {scores}</translation>
  </message>
  <message>
   <source>nothing: no frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>nada: ninguna imagen está anotada</translation>
  </message>
  <message>
   <source>export: cancelled; files that were written already are still there</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>exportar: cancelado; los archivos ya escritos siguen ahí</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames</source>
   <extracomment>{n:,} frame / {n:,} frames [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen</numerusform>
    <numerusform>{n:,} imágenes</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} elements</source>
   <extracomment>{n:,} element / {n:,} elements [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n:,} elemento</numerusform>
    <numerusform>{n:,} elementos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points</source>
   <extracomment>{n:,} point / {n:,} points [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} punto</numerusform>
    <numerusform>{n:,} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>Zip archive (*.zip);;Folder (*)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Archivo zip (*.zip);;Carpeta (*)</translation>
  </message>
  <message>
   <source>Save copies to</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Guardar copias en</translation>
  </message>
  <message numerus="yes">
   <source>copied {n:,} frames to {folder}; they are not saved in their own place yet</source>
   <extracomment>copied {n:,} frame to {folder}; it is not saved in its own place yet / copied {n:,} frames to {folder}; they are not saved in their own place yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen copiada a {folder}; aún no está guardada en su lugar</numerusform>
    <numerusform>{n:,} imágenes copiadas a {folder}; aún no están guardadas en su lugar</numerusform>
   </translation>
  </message>
  <message>
   <source>Table (*.csv);;JSON (*.json)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Tabla (*.csv);;JSON (*.json)</translation>
  </message>
  <message>
   <source>Table (*.csv)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Tabla (*.csv)</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} frames to {path}</source>
   <extracomment>exported {n:,} frame to {path} / exported {n:,} frames to {path} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen exportada a {path}</numerusform>
    <numerusform>{n:,} imágenes exportadas a {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the set was being scored still: some frames have no JaC yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>el conjunto aún se estaba puntuando: algunas imágenes no tienen JaC todavía</translation>
  </message>
  <message>
   <source>no camera to save: the fit is not there yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>no hay cámara que guardar: el ajuste aún no está</translation>
  </message>
  <message>
   <source>blind: no frame is committed yet, so there is no JaC to show</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>ciego: aún no hay ninguna imagen entregada, así que no hay JaC que mostrar</translation>
  </message>
  <message>
   <source>exported {what} to {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{what} exportado a {path}</translation>
  </message>
  <message>
   <source>Cancelled; files that were written already are still there.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Cancelado; los archivos ya escritos siguen ahí.</translation>
  </message>
  <message>
   <source>Not written</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>No escrito</translation>
  </message>
  <message>
   <source>What the format cannot hold</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Lo que el formato no puede guardar</translation>
  </message>
  <message>
   <source>everything is saved in its own place</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>todo está guardado en su lugar</translation>
  </message>
  <message>
   <source>no camera to save: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>no hay cámara que guardar: {why}</translation>
  </message>
  <message>
   <source>the fit is worked out again: save it in a moment</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>el ajuste se está recalculando: guárdelo en un momento</translation>
  </message>
  <message>
   <source>{frame}: the picture cannot be read, so that the camera's pixels belong to no size; not saved</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame}: la imagen no se puede leer, así que los píxeles de la cámara no corresponden a ningún tamaño; no guardado</translation>
  </message>
  <message>
   <source>saved as {path}, but the loaded cameras could not be read again: {problem}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>guardado como {path}, pero las cámaras cargadas no se pudieron leer otra vez: {problem}</translation>
  </message>
  <message>
   <source>{saved}; it is hardly determined: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{saved}; está apenas determinado: {why}</translation>
  </message>
  <message>
   <source>not everything could be saved: the export has the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>no se pudo guardar todo: la exportación tiene el último estado guardado</translation>
  </message>
  <message numerus="yes">
   <source>blind mode leaves out {n:,} frames not committed yet</source>
   <extracomment>blind mode leaves out {n:,} frame not committed yet / blind mode leaves out {n:,} frames not committed yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>el modo ciego deja fuera {n:,} imagen aún no entregada</numerusform>
    <numerusform>el modo ciego deja fuera {n:,} imágenes aún no entregadas</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} files could not be read: {problem}</source>
   <extracomment>{n:,} file could not be read: {problem} / {n:,} files could not be read: {problem} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} archivo no se pudo leer: {problem}</numerusform>
    <numerusform>{n:,} archivos no se pudieron leer: {problem}</numerusform>
   </translation>
  </message>
  <message>
   <source>Export</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Exportar</translation>
  </message>
  <message>
   <source>exporting {done} / {total}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>exportando {done} / {total}</translation>
  </message>
  <message>
   <source>Keep the field, and say nothing more of these classes</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Conservar el campo y no decir más de estas clases</translation>
  </message>
  <message>
   <source>The dataset remembers it, and is not asked about again</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>El conjunto lo recuerda y no se vuelve a preguntar</translation>
  </message>
  <message>
   <source>No, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>No, {field}</translation>
  </message>
  <message>
   <source>The field of this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>El campo de este conjunto</translation>
  </message>
  <message>
   <source>Descriptions of fields (*.toml)</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Descripciones de campos (*.toml)</translation>
  </message>
  <message>
   <source>Is this {field}? The classes annotated here are those of {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>¿Es esto {field}? Las clases anotadas aquí son las de {field}</translation>
  </message>
  <message>
   <source>{why}, but {file} in the dataset's folder decides</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{why}, pero decide {file} en la carpeta del conjunto</translation>
  </message>
  <message>
   <source>Yes, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Sí, {field}</translation>
  </message>
  <message>
   <source>Switch to {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Cambiar a {field}</translation>
  </message>
  <message>
   <source>{problem}; the field stays as it was: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{problem}; el campo quedó como estaba: {field}</translation>
  </message>
  <message>
   <source>Scores then differ from those of the nominal field ({nominal}), as official evaluations take it; they name the dimensions they were computed with.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Las puntuaciones difieren entonces de las del campo nominal ({nominal}), que es el de las evaluaciones oficiales; dicen con qué dimensiones se calcularon.</translation>
  </message>
  <message>
   <source>Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is for all others, and for what stadiums leave open.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Dimensiones propias (stadiums.csv): {frames} de {stadiums}. Lo que se introduce aquí vale para todas las demás, y para lo que los estadios dejan abierto.</translation>
  </message>
  <message>
   <source>Scores then differ from those of official evaluations, which take lines where the rules measure them; they say so.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Las puntuaciones difieren entonces de las evaluaciones oficiales, que toman las líneas donde las miden las reglas; lo dicen.</translation>
  </message>
  <message>
   <source>Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the paint's width away: choose it where that matters, as in halls and near the camera.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Las reglas miden muchas líneas en un borde de su pintura. Los clics se ponen en el medio, a media anchura de pintura: elíjalo donde eso importa, como en pabellones y cerca de la cámara.</translation>
  </message>
  <message>
   <source>Only length and width are found from frames, and the rules fix those of this field</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Solo la longitud y la anchura se hallan con las imágenes, y las reglas fijan las de este campo</translation>
  </message>
  <message numerus="yes">
   <source>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.</source>
   <extracomment>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame. / {dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{dimension}: {value:.2f} ± {sd:.2f} m, según {n} imagen.</numerusform>
    <numerusform>{dimension}: {value:.2f} ± {sd:.2f} m, según {n} imágenes.</numerusform>
   </translation>
  </message>
  <message>
   <source>where the rules measure</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>donde miden las reglas</translation>
  </message>
  <message>
   <source>the middle of the paint</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>el medio de la pintura</translation>
  </message>
  <message>
   <source>Field dimensions: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Dimensiones del campo: {field}</translation>
  </message>
  <message numerus="yes">
   <source>From the cameras of {n} frames; ± is one standard deviation.</source>
   <extracomment>From the cameras of {n} frame; ± is one standard deviation. / From the cameras of {n} frames; ± is one standard deviation. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>Con la cámara de {n} imagen; ± es una desviación típica.</numerusform>
    <numerusform>Con las cámaras de {n} imágenes; ± es una desviación típica.</numerusform>
   </translation>
  </message>
  <message>
   <source>{remark}; it stays as it was.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>{remark}; quedó como estaba.</translation>
  </message>
  <message>
   <source>Estimate from this set</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Estimar con este conjunto</translation>
  </message>
  <message>
   <source>Clicks lie on:</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Los clics están en:</translation>
  </message>
  <message>
   <source>Keep for this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Conservar para este conjunto</translation>
  </message>
  <message>
   <source>Nominal</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Nominal</translation>
  </message>
  <message>
   <source>The field as official evaluations take it</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>El campo que toman las evaluaciones oficiales</translation>
  </message>
  <message>
   <source>nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>nominal {nominal:g} m, las reglas permiten de {minimum:g} a {maximum:g} m</translation>
  </message>
  <message>
   <source>&lt;b&gt;not {number:g} m: the rules allow {minimum:g} to {maximum:g} m&lt;/b&gt;</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>&lt;b&gt;no {number:g} m: las reglas permiten de {minimum:g} a {maximum:g} m&lt;/b&gt;</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames</source>
   <extracomment>{n} frame / {n} frames [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} imagen</numerusform>
    <numerusform>{n} imágenes</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} stadiums</source>
   <extracomment>{n} stadium / {n} stadiums [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} estadio</numerusform>
    <numerusform>{n} estadios</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: frames that are not committed took no part ({n}).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Ciego: las imágenes no entregadas no participaron ({n}).</translation>
  </message>
  <message>
   <source>Frames that cannot be read took no part: {n}.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Las imágenes que no se pueden leer no participaron: {n}.</translation>
  </message>
  <message>
   <source>Stop</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py, procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Detener</translation>
  </message>
  <message>
   <source>the rules fix every dimension of the field {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>las reglas fijan todas las dimensiones del campo {field}</translation>
  </message>
  <message>
   <source>Blind: the set is checked once one of its frames is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Ciego: el conjunto se mira cuando una de sus imágenes está entregada (Ctrl+Intro).</translation>
  </message>
  <message>
   <source>no further frame this way: {what}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>no hay más imágenes en este sentido: {what}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: JaC {value:.3f}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} de {total}, las peores primero: JaC {value:.3f}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: largest error {value:.1f} px</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} de {total}, las peores primero: mayor error {value:.1f} px</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: median disagreement {value:.2f} m</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} de {total}, las peores primero: desacuerdo mediano {value:.2f} m</translation>
  </message>
  <message>
   <source>{place} of {total}, the least sure first</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} de {total}, las menos seguras primero</translation>
  </message>
  <message>
   <source>none is annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ninguna está anotada</translation>
  </message>
  <message>
   <source>all are annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>todas están anotadas</translation>
  </message>
  <message>
   <source>all are done or approved</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>todas están terminadas o aprobadas</translation>
  </message>
  <message>
   <source>none is rejected</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ninguna está rechazada</translation>
  </message>
  <message>
   <source>this is the last one</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>esta es la última</translation>
  </message>
  <message>
   <source>no frame with a score to go to</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>no hay ninguna imagen puntuada a la que ir</translation>
  </message>
  <message>
   <source>no frame with a score to go to: blind mode shows those of committed frames only</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>no hay imagen puntuada a la que ir: el modo ciego solo muestra las entregadas</translation>
  </message>
  <message>
   <source>comparing {source} with {other} over the set</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>comparando {source} con {other} en el conjunto</translation>
  </message>
  <message>
   <source>blind mode: how the track does is hidden</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>modo ciego: cómo va el seguimiento está oculto</translation>
  </message>
  <message>
   <source>no shot was followed yet (T)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>aún no se siguió ningún plano (T)</translation>
  </message>
  <message>
   <source>no other frame is unsure</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ninguna otra imagen es insegura</translation>
  </message>
  <message>
   <source>these frames do not follow one another</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>estas imágenes no van seguidas</translation>
  </message>
  <message>
   <source>two sources are needed to see where they disagree: load more cameras (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>hacen falta dos fuentes para ver dónde discrepan: cargue más cámaras (Ctrl+L)</translation>
  </message>
  <message>
   <source>{source} and {other} cannot be compared on the ground in any frame</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} y {other} no se pueden comparar sobre el suelo en ninguna imagen</translation>
  </message>
  <message>
   <source>stopped comparing the sources</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>comparación de las fuentes detenida</translation>
  </message>
  <message>
   <source>this is the worst; once more goes on</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>esta es la peor; otra vez sigue adelante</translation>
  </message>
  <message>
   <source>no other frame has a score</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ninguna otra imagen está puntuada</translation>
  </message>
  <message>
   <source>from the worst again</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>desde la peor otra vez</translation>
  </message>
  <message>
   <source>two sources are being compared already</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ya se están comparando dos fuentes</translation>
  </message>
  <message>
   <source>{source} and {other} are compared</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} y {other} están comparadas</translation>
  </message>
  <message>
   <source>none is doubtful</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ninguna es dudosa</translation>
  </message>
  <message>
   <source>skipped (under {least:.0%} visible): {ghosts}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>omitidos (visible menos del {least:.0%}): {ghosts}</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/commands/ghost_accepting.py, procc_annotator/gui/commands/versions.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>
    <numerusform>{n} punto</numerusform>
    <numerusform>{n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>{accepted}: {points}, line seen along {share:.0%}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{accepted}: {points}, línea vista en un {share:.0%}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ends of {elements} cannot be seen: the points stop before</source>
   <extracomment>{n} end of {elements} cannot be seen: the points stop before / {n} ends of {elements} cannot be seen: the points stop before [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} extremo de {elements} no se ve: los puntos acaban antes</numerusform>
    <numerusform>{n} extremos de {elements} no se ven: los puntos acaban antes</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera is another one meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>la cámara es otra entretanto</translation>
  </message>
  <message>
   <source>accept {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>aceptar {what}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts</source>
   <extracomment>{n} ghost / {n} ghosts [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} fantasma</numerusform>
    <numerusform>{n} fantasmas</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ghosts</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{n} de {total} fantasmas</translation>
  </message>
  <message>
   <source>accepted {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} aceptado</translation>
  </message>
  <message>
   <source>the frame was edited meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>la imagen se editó entretanto</translation>
  </message>
  <message>
   <source>looking for the line on {frame} took too long</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>buscar la línea en {frame} llevó demasiado tiempo</translation>
  </message>
  <message>
   <source>{element} is not accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} no está aceptado: {why}</translation>
  </message>
  <message>
   <source>{element}: no painted line is found along it; click it by hand, or say that it is not visible here (.)</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element}: no se halla ninguna línea pintada en él; márquelo a mano, o diga que no es visible aquí (.)</translation>
  </message>
  <message>
   <source>the camera is being fitted: accept its ghosts in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>se está ajustando la cámara: acepte sus fantasmas en un momento</translation>
  </message>
  <message>
   <source>no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes through them</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>no se aceptó ningún fantasma, visible menos del {least:.0%} de la línea: {ghosts}; Tab los recorre</translation>
  </message>
  <message>
   <source>accepted {what} on {frame}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} aceptado en {frame}</translation>
  </message>
  <message>
   <source>no ghost was accepted: there is no picture to look for their lines in</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>no se aceptó ningún fantasma: no hay imagen en que buscar sus líneas</translation>
  </message>
  <message>
   <source>no ghost was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>no se aceptó ningún fantasma: {why}</translation>
  </message>
  <message>
   <source>{element} is not accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} no está aceptado</translation>
  </message>
  <message>
   <source>the ghost is accepted: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>el fantasma está aceptado: acepte los fantasmas del nuevo ajuste</translation>
  </message>
  <message>
   <source>what was being drawn is finished: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>lo que se dibujaba está terminado: acepte los fantasmas del nuevo ajuste</translation>
  </message>
  <message>
   <source>no ghost was accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>no se aceptó ningún fantasma</translation>
  </message>
  <message>
   <source>{element} is accepted once its points are found</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} estará aceptado cuando se hallen sus puntos</translation>
  </message>
  <message>
   <source>go to a ghost (Tab) or choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>vaya primero a un fantasma (Tab) o elija un elemento</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts left, Tab begins again</source>
   <extracomment>{n} ghost left, Tab begins again / {n} ghosts left, Tab begins again [procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>
    <numerusform>queda {n} fantasma, Tab empieza de nuevo</numerusform>
    <numerusform>quedan {n} fantasmas, Tab empieza de nuevo</numerusform>
   </translation>
  </message>
  <message>
   <source>that was the last ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ese era el último fantasma</translation>
  </message>
  <message>
   <source>that was the first ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ese era el primer fantasma</translation>
  </message>
  <message>
   <source>the camera is being fitted: ghosts come in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>se está ajustando la cámara: los fantasmas llegan en un momento</translation>
  </message>
  <message>
   <source>no ghosts: the camera is looked for in the picture</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: se busca la cámara en la imagen</translation>
  </message>
  <message>
   <source>no ghosts: no camera is known; {advice}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: no se conoce ninguna cámara; {advice}</translation>
  </message>
  <message>
   <source>no ghosts: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: {why}</translation>
  </message>
  <message>
   <source>no ghosts: what else is in sight is annotated, or not known well enough</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: lo demás que está a la vista está anotado, o no se conoce lo bastante bien</translation>
  </message>
  <message>
   <source>no ghosts: they are switched off (Element &gt; Ghosts &gt; Show ghosts)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: están desactivados (Elemento &gt; Fantasmas &gt; Mostrar fantasmas)</translation>
  </message>
  <message>
   <source>overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>las superposiciones están ocultas: no se ve ningún fantasma (Ctrl+H, o suelte X)</translation>
  </message>
  <message>
   <source>finish what is being drawn first (Enter), or cancel it (Esc)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>termine primero lo que se dibuja (Intro), o cancélelo (Esc)</translation>
  </message>
  <message>
   <source>no ghosts: no camera could be fitted</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>no hay fantasmas: no se pudo ajustar ninguna cámara</translation>
  </message>
  <message>
   <source>no camera fits yet</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>aún no se ajusta ninguna cámara</translation>
  </message>
  <message>
   <source>it is being drawn by hand</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>se está dibujando a mano</translation>
  </message>
  <message>
   <source>{title} is annotated here: delete it first (Ctrl+Delete)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} está anotado aquí: bórrelo primero (Ctrl+Supr)</translation>
  </message>
  <message>
   <source>{title} is not visible here; Ctrl+. takes it back</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} no es visible aquí; Ctrl+. lo retira</translation>
  </message>
  <message>
   <source>{title} may be visible here again</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} quizá vuelva a ser visible aquí</translation>
  </message>
  <message>
   <source>no element of this frame was said to be not visible</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>de ningún elemento de esta imagen se dijo que no fuera visible</translation>
  </message>
  <message>
   <source>go to a ghost first (Tab)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>vaya primero a un fantasma (Tab)</translation>
  </message>
  <message>
   <source>{off}; choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{off}; elija primero un elemento</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported ({format}).</source>
   <extracomment>{edited} of {n:,} frame imported ({format}). / {edited} of {n:,} frames imported ({format}). [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} de {n:,} imagen importada ({format}).</numerusform>
    <numerusform>{edited} de {n:,} imágenes importadas ({format}).</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Cancelled: {n:,} frames were not checked.</source>
   <extracomment>Cancelled: {n:,} frame was not checked. / Cancelled: {n:,} frames were not checked. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>Cancelado: {n:,} imagen no se miró.</numerusform>
    <numerusform>Cancelado: {n:,} imágenes no se miraron.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are annotated already and left unchanged.</source>
   <extracomment>{n:,} frame is annotated already and left unchanged. / {n:,} frames are annotated already and left unchanged. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen ya está anotada y quedó sin cambios.</numerusform>
    <numerusform>{n:,} imágenes ya están anotadas y quedaron sin cambios.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames hold the same already.</source>
   <extracomment>{n:,} frame holds the same already. / {n:,} frames hold the same already. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen ya contiene lo mismo.</numerusform>
    <numerusform>{n:,} imágenes ya contienen lo mismo.</numerusform>
   </translation>
  </message>
  <message>
   <source>import</source>
   <comment>a step</comment>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>importar</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported</source>
   <extracomment>{edited} of {n:,} frame imported / {edited} of {n:,} frames imported [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} de {n:,} imagen importada</numerusform>
    <numerusform>{edited} de {n:,} imágenes importadas</numerusform>
   </translation>
  </message>
  <message>
   <source>Cancelled; nothing was imported.</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Cancelado; no se importó nada.</translation>
  </message>
  <message>
   <source>Left as they were</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Dejadas como estaban</translation>
  </message>
  <message>
   <source>Could not be read</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>No se pudieron leer</translation>
  </message>
  <message>
   <source>Without a picture here ({n})</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Sin imagen aquí ({n})</translation>
  </message>
  <message>
   <source>Changed or left out</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Cambiadas o dejadas fuera</translation>
  </message>
  <message>
   <source>it could not be saved: {why}</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>no se pudo guardar: {why}</translation>
  </message>
  <message>
   <source>error</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>error</translation>
  </message>
  <message>
   <source>warning</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>aviso</translation>
  </message>
  <message>
   <source>hint</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>indicio</translation>
  </message>
  <message>
   <source>finding {place} of {total}, {severity}: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>hallazgo {place} de {total}, {severity}: {elements}</translation>
  </message>
  <message>
   <source>no finding is as sure as the Check panel is set to show</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>ningún hallazgo es tan seguro como pide el panel Comprobación</translation>
  </message>
  <message numerus="yes">
   <source>relabelled {n} elements</source>
   <extracomment>relabelled {n} element / relabelled {n} elements [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n} elemento con otra clase</numerusform>
    <numerusform>{n} elementos con otra clase</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>checked {n:,} frames, camera model {model}: {found}</source>
   <extracomment>checked {n:,} frame, camera model {model}: {found} / checked {n:,} frames, camera model {model}: {found} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen revisada, modelo de cámara {model}: {found}</numerusform>
    <numerusform>{n:,} imágenes revisadas, modelo de cámara {model}: {found}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} checked frames</source>
   <extracomment>{n:,} checked frame / {n:,} checked frames [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen revisada</numerusform>
    <numerusform>{n:,} imágenes revisadas</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} y {other}</translation>
  </message>
  <message>
   <source>the label check is still looking at this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la revisión de clases aún examina esta imagen</translation>
  </message>
  <message>
   <source>the label check has found nothing; check the whole set to look at all frames</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la revisión de clases no ha hallado nada; revise todo el conjunto para mirar todas las imágenes</translation>
  </message>
  <message>
   <source>{done}; Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{done}; Ctrl+Z lo retira</translation>
  </message>
  <message>
   <source>removed point {n} of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>punto {n} de {element} quitado</translation>
  </message>
  <message>
   <source>swapped {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} y {other} intercambiados</translation>
  </message>
  <message>
   <source>relabelled {element} to {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} pasado a {other}</translation>
  </message>
  <message>
   <source>ignored until {elements} changes; the Check panel brings it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>ignorado hasta que cambie {elements}; el panel Comprobación lo devuelve</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked</source>
   <extracomment>{n:,} frame cannot be checked / {n:,} frames cannot be checked [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen no se puede revisar</numerusform>
    <numerusform>{n:,} imágenes no se pueden revisar</numerusform>
   </translation>
  </message>
  <message>
   <source>Export findings</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Exportar hallazgos</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} findings in {frames} to {path}</source>
   <extracomment>exported {n:,} finding in {frames} to {path} / exported {n:,} findings in {frames} to {path} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} hallazgo en {frames} exportado a {path}</numerusform>
    <numerusform>{n:,} hallazgos en {frames} exportados a {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>the label check has found nothing</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la revisión de clases no ha hallado nada</translation>
  </message>
  <message>
   <source>the elements have changed since: checked again</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>los elementos han cambiado desde entonces: revisados de nuevo</translation>
  </message>
  <message>
   <source>removed point of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>punto de {element} quitado</translation>
  </message>
  <message>
   <source>go to a finding first (F10)</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>vaya primero a un hallazgo (F10)</translation>
  </message>
  <message>
   <source>stopped checking the set; what was found stays</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>revisión del conjunto detenida; lo hallado queda</translation>
  </message>
  <message>
   <source>the label check has found nothing in this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>la revisión de clases no ha hallado nada en esta imagen</translation>
  </message>
  <message>
   <source>nothing found</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>nada hallado</translation>
  </message>
  <message>
   <source>no remedy is known: {reason}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>no se conoce remedio: {reason}</translation>
  </message>
  <message>
   <source>cameras opened here before are not opened again: {why}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>las cámaras abiertas aquí antes no se abren de nuevo: {why}</translation>
  </message>
  <message>
   <source>Open a video</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Abrir un vídeo</translation>
  </message>
  <message>
   <source>One frame every</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Una imagen cada</translation>
  </message>
  <message>
   <source>The first frame of every scene</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>La primera imagen de cada escena</translation>
  </message>
  <message>
   <source>Looks through the whole video for cuts; this takes a while</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Busca cortes en todo el vídeo; tarda un rato</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, the field american_football, the menus]</extracomment>
   <translation>Campo</translation>
  </message>
  <message>
   <source>Reading {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Leyendo {file}</translation>
  </message>
  <message>
   <source>Looking for cuts in {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Buscando cortes en {file}</translation>
  </message>
  <message>
   <source>Pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Imágenes</translation>
  </message>
  <message>
   <source>Videos</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Vídeos</translation>
  </message>
  <message>
   <source>Nothing is extracted; “Keep this video frame” writes a picture.</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>No se extrae nada; «Conservar esta imagen del vídeo» escribe un archivo.</translation>
  </message>
  <message>
   <source>cameras opened here before are not there any more: {paths}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>las cámaras abiertas aquí antes ya no están: {paths}</translation>
  </message>
  <message>
   <source>this frame is a picture already</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>esta imagen ya es un archivo de imagen</translation>
  </message>
  <message>
   <source>kept as {path}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>conservada como {path}</translation>
  </message>
  <message>
   <source>the sample comes with the source, not here</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/tour.py]</extracomment>
   <translation>el ejemplo viene con el código fuente, no aquí</translation>
  </message>
  <message>
   <source>your own copy, in {folder}; load its cameras from the menu Camera</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>su propia copia, en {folder}; cargue sus cámaras desde el menú Cámara</translation>
  </message>
  <message>
   <source>Load a folder of cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cargar una carpeta de cámaras</translation>
  </message>
  <message>
   <source>Load cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cargar cámaras</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Cámaras</translation>
  </message>
  <message>
   <source>Open a folder of pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Abrir una carpeta de imágenes</translation>
  </message>
  <message>
   <source>Open a picture</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Abrir una imagen</translation>
  </message>
  <message>
   <source>Open a second annotator's folder</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Abrir la carpeta de un segundo anotador</translation>
  </message>
  <message>
   <source>{width} x {height} px, without the legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, sin la leyenda</translation>
  </message>
  <message>
   <source>{width} x {height} px, too large: choose a smaller scale or SVG</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, demasiado grande: elija una escala menor o SVG</translation>
  </message>
  <message>
   <source>PNG: pixels, nothing is lost</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>PNG: píxeles, sin pérdida</translation>
  </message>
  <message>
   <source>JPEG: pixels, small</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>JPEG: píxeles, pequeño</translation>
  </message>
  <message>
   <source>SVG: lines and text stay sharp</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>SVG: líneas y texto siempre nítidos</translation>
  </message>
  <message>
   <source>Picture (*{suffix})</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Imagen (*{suffix})</translation>
  </message>
  <message>
   <source>Save overlay picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Guardar imagen superpuesta</translation>
  </message>
  <message>
   <source>Px of the result per px of the picture; lines and text grow with it</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Px del resultado por px de la imagen; líneas y texto crecen con ella</translation>
  </message>
  <message>
   <source>Explain colours, dashes and marks below the picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Explicar bajo la imagen los colores, trazos y marcas</translation>
  </message>
  <message>
   <source>&amp;Kind</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Tipo</translation>
  </message>
  <message>
   <source>&amp;Scale</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Escala</translation>
  </message>
  <message>
   <source>Result</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Resultado</translation>
  </message>
  <message>
   <source>&amp;Legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Leyenda</translation>
  </message>
  <message>
   <source>writing the overlay picture {path} …</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>escribiendo la imagen superpuesta {path} …</translation>
  </message>
  <message>
   <source>open a picture first</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>abra primero una imagen</translation>
  </message>
  <message>
   <source>{path}: is the picture itself, choose another name</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{path}: es la propia imagen, elija otro nombre</translation>
  </message>
  <message>
   <source>overlay picture written to {path}</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>imagen superpuesta escrita en {path}</translation>
  </message>
  <message>
   <source>waiting</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>en espera</translation>
  </message>
  <message>
   <source>begun</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>empezado</translation>
  </message>
  <message>
   <source>done</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>terminado</translation>
  </message>
  <message>
   <source>failed</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>fallido</translation>
  </message>
  <message>
   <source>Match</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Partido</translation>
  </message>
  <message>
   <source>Stadium</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Estadio</translation>
  </message>
  <message>
   <source>Start</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Inicio</translation>
  </message>
  <message>
   <source>State</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Estado</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/commands/season.py, procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Imágenes</translation>
  </message>
  <message>
   <source>Tracked</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Seguidos</translation>
  </message>
  <message>
   <source>On paint</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Sobre pintura</translation>
  </message>
  <message>
   <source>Failed units</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Unidades fallidas</translation>
  </message>
  <message>
   <source>Season</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Temporada</translation>
  </message>
  <message>
   <source>Search: match, stadium, state</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Buscar: partido, estadio, estado</translation>
  </message>
  <message>
   <source>Tracked cameras…</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Cámaras seguidas…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} matches</source>
   <extracomment>{n:,} match / {n:,} matches [procc_annotator/gui/commands/season.py]</extracomment>
   <translation>
    <numerusform>{n:,} partido</numerusform>
    <numerusform>{n:,} partidos</numerusform>
   </translation>
  </message>
  <message>
   <source>The folder that track writes to</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>La carpeta en la que escribe track</translation>
  </message>
  <message>
   <source>Matches</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Partidos</translation>
  </message>
  <message>
   <source>open a season first: a folder in which videos lie, or a list of them</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>abra primero una temporada: una carpeta con vídeos o una lista de ellos</translation>
  </message>
  <message>
   <source>it is annotated by now</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>ya está anotada entretanto</translation>
  </message>
  <message>
   <source>it was edited since</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>se editó desde entonces</translation>
  </message>
  <message>
   <source>no frame to accept: follow the shot first (T)</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>ninguna imagen que aceptar: siga primero el plano (T)</translation>
  </message>
  <message>
   <source>the shot is still being followed: wait for its end, or stop it (T), then accept</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aún se está siguiendo el plano: espere a que termine o deténgalo (T) y luego acepte</translation>
  </message>
  <message>
   <source>no frame to accept: all that were followed are annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>ninguna imagen que aceptar: todas las seguidas están anotadas</translation>
  </message>
  <message>
   <source>every frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>todas las imágenes están anotadas</translation>
  </message>
  <message>
   <source>blind mode: nothing is accepted that was not clicked</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>modo ciego: no se acepta nada que no se haya marcado</translation>
  </message>
  <message numerus="yes">
   <source>all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it / all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen es dudosa ({why}): mírela; Ctrl+Mayús+Intro otra vez la acepta</numerusform>
    <numerusform>las {n:,} imágenes son dudosas ({why}): mire algunas; Ctrl+Mayús+Intro otra vez las acepta</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points: {done} of {total} frames  ·  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>buscando puntos de línea: {done} de {total} imágenes  ·  Esc lo detiene</translation>
  </message>
  <message>
   <source>accept elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>aceptar elementos</translation>
  </message>
  <message>
   <source>take back accepted elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>retirar los elementos aceptados</translation>
  </message>
  <message numerus="yes">
   <source>annotated {n:,} frames</source>
   <extracomment>annotated {n:,} frame / annotated {n:,} frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen anotada</numerusform>
    <numerusform>{n:,} imágenes anotadas</numerusform>
   </translation>
  </message>
  <message>
   <source>Ctrl+Z takes them back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Ctrl+Z las retira</translation>
  </message>
  <message numerus="yes">
   <source>taken back: {n:,} annotated frames</source>
   <extracomment>taken back: {n:,} annotated frame / taken back: {n:,} annotated frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>retirado: {n:,} imagen anotada</numerusform>
    <numerusform>retirado: {n:,} imágenes anotadas</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames left: {why}</source>
   <extracomment>{n:,} frame left: {why} / {n:,} frames left: {why} [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen dejada: {why}</numerusform>
    <numerusform>{n:,} imágenes dejadas: {why}</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points …  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>buscando puntos de línea …  Esc lo detiene</translation>
  </message>
  <message>
   <source>no frame was annotated: too little of their lines is seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>no se anotó ninguna imagen: se ve demasiado poco de sus líneas</translation>
  </message>
  <message>
   <source>no frame was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>no se aceptó ninguna imagen: {why}</translation>
  </message>
  <message>
   <source>nothing was accepted that could be taken back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>no se aceptó nada que pudiera retirarse</translation>
  </message>
  <message>
   <source>taken back: no frame is accepted</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>retirado: ninguna imagen está aceptada</translation>
  </message>
  <message>
   <source>no frame was annotated: no camera is sure</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>no se anotó ninguna imagen: ninguna cámara es segura</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first</source>
   <extracomment>{n:,} frame is not sure: Alt+PgDown shows it / {n:,} frames are not sure: Alt+PgDown goes through them, the least sure first [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen no es segura: Alt+Av Pág la muestra</numerusform>
    <numerusform>{n:,} imágenes no son seguras: Alt+Av Pág las recorre, las menos seguras primero</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it / {n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>queda {n:,} imagen dudosa: Ctrl+Mayús+Intro otra vez la acepta</numerusform>
    <numerusform>quedan {n:,} imágenes dudosas: Ctrl+Mayús+Intro otra vez las acepta</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera of this frame is unsure: a sure one is looked for in the shot; look at this one, accept its lines (Shift+Enter), then T follows them</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>la cámara de esta imagen es insegura: se busca una segura en el plano; mire esta, acepte sus líneas (Mayús+Intro) y T las seguirá</translation>
  </message>
  <message>
   <source>no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or {advice}; then T follows it</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>ninguna imagen del plano tiene una cámara segura: acepte las líneas de una (Mayús+Intro), o {advice}; entonces T la sigue</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen seguida, {doubtful:,} dudosas (Alt+Av Pág); Ctrl+Mayús+Intro acepta las seguras</numerusform>
    <numerusform>{n:,} imágenes seguidas, {doubtful:,} dudosas (Alt+Av Pág); Ctrl+Mayús+Intro acepta las seguras</numerusform>
   </translation>
  </message>
  <message>
   <source>following: {done} of {total} frames  ·  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>siguiendo: {done} de {total} imágenes  ·  T lo detiene</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen seguida, segura; Ctrl+Mayús+Intro acepta las seguras</numerusform>
    <numerusform>{n:,} imágenes seguidas, todas seguras; Ctrl+Mayús+Intro acepta las seguras</numerusform>
   </translation>
  </message>
  <message>
   <source>looking for the ends of the shot …  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>buscando los extremos del plano …  T lo detiene</translation>
  </message>
  <message>
   <source>the shot could not be followed: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>no se pudo seguir el plano: {why}</translation>
  </message>
  <message>
   <source>only a video, or frames that follow one another, can be followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>solo se puede seguir un vídeo, o imágenes que van seguidas</translation>
  </message>
  <message>
   <source>blind mode: no shot is followed, its cameras would be seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>modo ciego: no se sigue ningún plano, se verían sus cámaras</translation>
  </message>
  <message>
   <source>stopped; what was followed so far stays</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>detenido; lo seguido hasta ahora queda</translation>
  </message>
  <message>
   <source>stopped; nothing was followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>detenido; no se siguió nada</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Levantarlo muestra cámaras, fantasmas y el ajuste a todos los que lo anotan. Queda registrado con el conjunto que {author} lo levantó, y cuándo.</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Levantarlo le muestra a usted cámaras, fantasmas y el ajuste; para otros no estaba fijado. Queda registrado con el conjunto que {author} lo levantó, y cuándo.</translation>
  </message>
  <message>
   <source>blind mode leaves out {n} on frames that are not committed</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>el modo ciego deja fuera {n} de imágenes no entregadas</translation>
  </message>
  <message>
   <source>{frame}: no verdict on {source} any more</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{frame}: ya sin veredicto sobre {source}</translation>
  </message>
  <message>
   <source>Note on the verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Nota al veredicto</translation>
  </message>
  <message>
   <source>What is wrong here:</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Qué está mal aquí:</translation>
  </message>
  <message>
   <source>Export verdicts</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Exportar veredictos</translation>
  </message>
  <message>
   <source>blind: no frame that is committed has a verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>ciego: ninguna imagen entregada tiene veredicto</translation>
  </message>
  <message>
   <source>no frame has a verdict yet: mark one first</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>ninguna imagen tiene veredicto aún: dé uno primero</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} verdicts to {path}</source>
   <extracomment>exported {n:,} verdict to {path} / exported {n:,} verdicts to {path} [procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>
    <numerusform>{n:,} veredicto exportado a {path}</numerusform>
    <numerusform>{n:,} veredictos exportados a {path}</numerusform>
   </translation>
  </message>
  <message>
   <source>mark the frame first: camera wrong, labels wrong or fine</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>dé primero un veredicto: cámara errónea, anotación errónea u OK</translation>
  </message>
  <message>
   <source>not everything could be saved: the figures are of the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>no se pudo guardar todo: las cifras son del último estado guardado</translation>
  </message>
  <message>
   <source>{source} follows the clicks: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} sigue los clics: un veredicto es sobre una cámara que se cargó</translation>
  </message>
  <message>
   <source>{source} is worked out here: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} se calcula aquí: un veredicto es sobre una cámara que se cargó</translation>
  </message>
  <message>
   <source>There is no earlier version of this frame.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>No hay versión anterior de esta imagen.</translation>
  </message>
  <message>
   <source>Compared with now: {changes}. What differs: {elements}.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Comparado con ahora: {changes}. Lo que difiere: {elements}.</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>no se puede leer</translation>
  </message>
  <message>
   <source>empty</source>
   <comment>a version</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>vacía</translation>
  </message>
  <message>
   <source>as now</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>como ahora</translation>
  </message>
  <message>
   <source>other elements</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>otros elementos</translation>
  </message>
  <message>
   <source>points moved</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>puntos movidos</translation>
  </message>
  <message>
   <source>This is what the frame holds now.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Esto es lo que la imagen contiene ahora.</translation>
  </message>
  <message>
   <source>Compared with now: the same points in another order of elements.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Comparado con ahora: los mismos puntos en otro orden de elementos.</translation>
  </message>
  <message>
   <source>restore an earlier version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>recuperar una versión anterior</translation>
  </message>
  <message>
   <source>Earlier versions</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Versiones anteriores</translation>
  </message>
  <message>
   <source>Restore</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Recuperar</translation>
  </message>
  <message>
   <source>%d %b %Y, %H:%M:%S</source>
   <comment>a moment; the month as %b is English, as %m a number</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>%d/%m/%Y, %H:%M:%S</translation>
  </message>
  <message>
   <source>{n} more</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>{n} más</translation>
  </message>
  <message>
   <source>the earlier version is back; undo takes it away again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>la versión anterior ha vuelto; deshacer la quita otra vez</translation>
  </message>
  <message>
   <source>the earlier version is back; what could not be read stays a version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>la versión anterior vuelve a estar ahí; lo que no se podía leer se conserva como versión</translation>
  </message>
  <message>
   <source>the frame was changed elsewhere: look at it, then restore again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>la imagen se cambió en otra parte: mírela y recupere de nuevo</translation>
  </message>
  <message>
   <source>Frames of one instant from different cameras are one group. Their names tell which, by a pattern: &lt;b&gt;{instant}&lt;/b&gt; stands for when a frame was taken, &lt;b&gt;{view}&lt;/b&gt; for the camera, all else for itself. A regular expression with &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; and &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; does it, too.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Las imágenes de un instante desde distintas cámaras son un grupo. Sus nombres lo dicen según un patrón: &lt;b&gt;{instant}&lt;/b&gt; representa cuándo se tomó una imagen, &lt;b&gt;{view}&lt;/b&gt; la cámara, y todo lo demás a sí mismo. También sirve una expresión regular con &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; y &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt;.</translation>
  </message>
  <message>
   <source>No pattern was found that fits these names: write one.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>No se halló ningún patrón que encaje con estos nombres: escriba uno.</translation>
  </message>
  <message>
   <source>What it says now is lost, with everything else that is written in it.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Lo que dice ahora se pierde, con todo lo demás que hay escrito en él.</translation>
  </message>
  <message>
   <source>Instant</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Instante</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups of {least} to {most}</source>
   <extracomment>{frames} in {n:,} group of {least} to {most} / {frames} in {n:,} groups of {least} to {most} [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} en {n:,} grupo de {least} a {most}</numerusform>
    <numerusform>{frames} en {n:,} grupos de {least} a {most}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} of {n:,} instants</source>
   <extracomment>{frames} of {n:,} instant / {frames} of {n:,} instants [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} de {n:,} instante</numerusform>
    <numerusform>{frames} de {n:,} instantes</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames, none grouped.</source>
   <extracomment>{n:,} frame, none grouped. / {n:,} frames, none grouped. [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen, sin agrupar.</numerusform>
    <numerusform>{n:,} imágenes, ninguna agrupada.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups</source>
   <extracomment>{frames} in {n:,} group / {frames} in {n:,} groups [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} en {n:,} grupo</numerusform>
    <numerusform>{frames} en {n:,} grupos</numerusform>
   </translation>
  </message>
  <message>
   <source>This name does not fit the pattern: the frame stands alone</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Este nombre no encaja en el patrón: la imagen queda sola</translation>
  </message>
  <message>
   <source>{file} groups {sizes} from now on</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} agrupa {sizes} desde ahora</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} instants with one frame only</source>
   <extracomment>{n:,} instant with one frame only / {n:,} instants with one frame only [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} instante con una sola imagen</numerusform>
    <numerusform>{n:,} instantes con una sola imagen</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} names do not fit (last in the table)</source>
   <extracomment>{n:,} name does not fit (last in the table) / {n:,} names do not fit (last in the table) [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} nombre no encaja (al final de la tabla)</numerusform>
    <numerusform>{n:,} nombres no encajan (al final de la tabla)</numerusform>
   </translation>
  </message>
  <message>
   <source>Group views</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Agrupar vistas</translation>
  </message>
  <message>
   <source>{file} is there already: {sizes}.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} ya existe: {sizes}.</translation>
  </message>
  <message>
   <source>Write {file}</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Escribir {file}</translation>
  </message>
  <message>
   <source>Keep these groups in the dataset's folder</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Conservar estos grupos en la carpeta del conjunto</translation>
  </message>
  <message>
   <source>Groups of frames</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Grupos de imágenes</translation>
  </message>
  <message>
   <source>Pattern of the frames' names</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Patrón de los nombres de las imágenes</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} elemento, simetrías: {turns}</numerusform>
    <numerusform>{n} elementos, simetrías: {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Aún no hay ningún campo que mostrar.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}: {value:.10g} m (las reglas permiten de {least:g} a {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... y {n} más</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>ninguna</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>lo que se mantiene pulsado en la imagen</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Habituales</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Para zurdos</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Como CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Como labelme</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Rueda</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>zoom en el cursor</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Dos dedos</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>desplazar; al pellizcar, zoom</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mayús + rueda</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>desplazar a los lados, como una rueda inclinada</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Espacio + arrastrar</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>desplazar</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Botón central</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mantener X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ocultar todas las superposiciones</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mantener Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>lupa: ocho veces los píxeles de la imagen</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mantener ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>mirar la fuente de cámaras comparada</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Pulsar ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>juzgar con la fuente comparada, comparar con esta</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mantener Ctrl</translation>
  </message>
  <message>
   <source>click off the line: no snapping</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>marcar junto a la línea: sin ajuste</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + arrastrar una línea</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>cámara: sigue, y el lugar queda como estaca</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + clic en una estaca</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>cámara: quitar la estaca</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/keymap.py, procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flechas</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>retícula: las teclas señalan; si hay puntos elegidos, se mueven ellos</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Espacio en la retícula</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>lo que hace allí un clic (con Ctrl: sin ajuste)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Botón derecho</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>menú de lo que hay bajo el cursor</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Intro</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>aceptar el fantasma actual</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mayús+Intro</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>aceptar todos los fantasmas</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Clic</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>dibujar: añadir un punto</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Doble clic</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>dibujar: terminar</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Arrastrar un punto</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: moverlo</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mayús+clic en un punto</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: elegir varios</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Arrastrar sobre un lugar vacío</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: elegir los puntos de dentro</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Arrastrar una línea</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: mover el elemento, salvo que estén fijados</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+clic en una línea</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: insertar un punto</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Mayús+clic</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>editar: quitar el punto</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Clic o arrastrar en la tira</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ir a una imagen</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Rueda sobre la tira</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>zoom; con Mayús, desplazar</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mayús+arrastrar en la tira</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>marcar un tramo (un doble clic lo suelta)</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>se esperaba un objeto con "actions" y "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" y "elements": se esperaban objetos</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: {value!r} no es una tecla; se esperaba una como {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: se esperaba una lista de teclas, como {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Paneles</translation>
  </message>
  <message>
   <source>Choose another place…</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Elegir otro lugar…</translation>
  </message>
  <message>
   <source>Save copies to…</source>
   <extracomment>[procc_annotator/gui/messages.py, the action save_copies]</extracomment>
   <translation>Guardar copias en…</translation>
  </message>
  <message>
   <source>Copy details</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Copiar detalles</translation>
  </message>
  <message>
   <source>Show the next</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mostrar la siguiente</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} ya existe y dice otra cosa.</translation>
  </message>
  <message numerus="yes">
   <source>{n} comments on this frame are not settled.</source>
   <extracomment>{n} comment on this frame is not settled. / {n} comments on this frame are not settled. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} comentario sobre esta imagen no está resuelto.</numerusform>
    <numerusform>{n} comentarios sobre esta imagen no están resueltos.</numerusform>
   </translation>
  </message>
  <message>
   <source>A tick in the Review panel settles a comment.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Una marca en el panel «Revisión» resuelve un comentario.</translation>
  </message>
  <message>
   <source>{n:,} of {total:,} frames are not done.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{n:,} de {total:,} imágenes no están terminadas.</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} imagen no está guardada, y guardar acaba de fallar otra vez.</numerusform>
    <numerusform>{n} imágenes no están guardadas, y guardar acaba de fallar otra vez.</numerusform>
   </translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mostrar lo que hay en el archivo; deshacer devuelve su versión</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Escribir lo que ve en pantalla sobre el archivo</translation>
  </message>
  <message>
   <source>Export all</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Exportar todas</translation>
  </message>
  <message>
   <source>Done only</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Solo terminadas</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Quitar este mensaje</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Recargar lo suyo</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Sobrescribir con lo mío</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>¿Borrar {what}?</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Conservarlo</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Borrar</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Reemplazarlo</translation>
  </message>
  <message>
   <source>Do not approve</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>No aprobar</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/review.py, the action approve]</extracomment>
   <translation>Aprobar</translation>
  </message>
  <message>
   <source>Keep it locked</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mantenerlo fijado</translation>
  </message>
  <message>
   <source>Unlock, and record it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Levantarlo y registrarlo</translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Quedarse</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Cerrar y perderlas</translation>
  </message>
  <message>
   <source>Open a second annotator's folder (menu File) to compare the clicks of both.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Abra la carpeta de un segundo anotador (menú Archivo) para comparar los clics de ambos.</translation>
  </message>
  <message>
   <source>Apart: the two share (almost) no stretch of this element, which is no agreement. Was its class swapped with a neighbour's?</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Separados: los dos no comparten (casi) ningún tramo de este elemento, lo que no es concordancia. ¿Se confundió su clase con la de un vecino?</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks compared</source>
   <extracomment>{n:,} click compared / {n:,} clicks compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} clic comparado</numerusform>
    <numerusform>{n:,} clics comparados</numerusform>
   </translation>
  </message>
  <message>
   <source>{part} of {total}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{part} de {total}</translation>
  </message>
  <message>
   <source>apart</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>separados</translation>
  </message>
  <message numerus="yes">
   <source>{compared}, {n} left out: beyond the ends of what the other clicked</source>
   <extracomment>{compared}, {n} left out: beyond the ends of what the other clicked / {compared}, {n} left out: beyond the ends of what the other clicked [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{compared}, {n} dejado fuera: más allá de los extremos de lo que marcó el otro</numerusform>
    <numerusform>{compared}, {n} dejados fuera: más allá de los extremos de lo que marcó el otro</numerusform>
   </translation>
  </message>
  <message>
   <source>Measuring the set…</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Midiendo el conjunto…</translation>
  </message>
  <message>
   <source>Distances by element</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Distancias por elemento</translation>
  </message>
  <message>
   <source>Close the second annotator</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Cerrar el segundo anotador</translation>
  </message>
  <message>
   <source>The second annotator's file for this frame is unreadable: {error}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>El archivo del segundo anotador para esta imagen es ilegible: {error}</translation>
  </message>
  <message>
   <source>Agreement JaC at {tau:g} px: {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>JaC de concordancia a {tau:g} px: {jac:.3f}</translation>
  </message>
  <message>
   <source>No element is annotated by both in any frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Ningún elemento está anotado por ambos en ninguna imagen.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames unreadable, not compared</source>
   <extracomment>{n:,} frame unreadable, not compared / {n:,} frames unreadable, not compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen ilegible, no comparada</numerusform>
    <numerusform>{n:,} imágenes ilegibles, no comparadas</numerusform>
   </translation>
  </message>
  <message>
   <source>Median</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mediana</translation>
  </message>
  <message>
   <source>Points</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Puntos</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows the score once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Oculto: el modo ciego muestra la puntuación una vez entregada esta imagen.</translation>
  </message>
  <message>
   <source>One of the two seems to label the field turned by 180 degrees.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Uno de los dos parece nombrar el campo girado 180 grados.</translation>
  </message>
  <message>
   <source>Apart: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Separados: {elements}</translation>
  </message>
  <message>
   <source>Only here: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Solo aquí: {elements}</translation>
  </message>
  <message>
   <source>Only there: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Solo allí: {elements}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks beyond the other's ends, left out</source>
   <extracomment>{n:,} click beyond the other's ends, left out / {n:,} clicks beyond the other's ends, left out [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} clic más allá de los extremos del otro, dejado fuera</numerusform>
    <numerusform>{n:,} clics más allá de los extremos del otro, dejados fuera</numerusform>
   </translation>
  </message>
  <message>
   <source>Nothing to measure noise by: all elements annotated by both are apart.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Nada con que medir el ruido: todos los elementos anotados por ambos están separados.</translation>
  </message>
  <message numerus="yes">
   <source>Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height})</source>
   <extracomment>Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) / Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>Ruido humano en {n:,} imagen: mediana {median:.2f} px, 95 % dentro de {p95:.2f} px (a {width}x{height})</numerusform>
    <numerusform>Ruido humano en {n:,} imágenes: mediana {median:.2f} px, 95 % dentro de {p95:.2f} px (a {width}x{height})</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>and {n} more</source>
   <extracomment>and {n} more / and {n} more [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>y {n} más</numerusform>
    <numerusform>y {n} más</numerusform>
   </translation>
  </message>
  <message>
   <source>The second annotator has nothing for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>El segundo anotador no tiene nada para esta imagen.</translation>
  </message>
  <message>
   <source>Frames of this dataset that have a camera (completeness)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Imágenes de este conjunto que tienen cámara (completitud)</translation>
  </message>
  <message>
   <source>Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the fit was made from.
procc-annotator calibrate fits and scores the whole set</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Imágenes visitadas en esta ventana cuyos clics dieron una cámara; su JaC es el de los clics con que se hizo el ajuste.
procc-annotator calibrate ajusta y puntúa todo el conjunto</translation>
  </message>
  <message>
   <source>Frames of this dataset that were followed through their shot and have a camera.
procc-annotator track follows a whole video and writes its cameras</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Imágenes de este conjunto que se siguieron a lo largo de su plano y tienen cámara.
procc-annotator track sigue un vídeo entero y escribe sus cámaras</translation>
  </message>
  <message>
   <source>Yellow</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Amarillo</translation>
  </message>
  <message>
   <source>Violet</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Violeta</translation>
  </message>
  <message>
   <source>Blue</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Azul</translation>
  </message>
  <message>
   <source>Mint</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Menta</translation>
  </message>
  <message>
   <source>Navy</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Azul marino</translation>
  </message>
  <message>
   <source>Cyan</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Cian</translation>
  </message>
  <message>
   <source>Switch the live fit off (Ctrl+T switches it on again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Desactivar el ajuste continuo (Ctrl+T lo activa de nuevo)</translation>
  </message>
  <message>
   <source>Name of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Nombre de la fuente</translation>
  </message>
  <message>
   <source>Draw as a wireframe while another source is judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Dibujar como armazón mientras se juzga otra fuente</translation>
  </message>
  <message>
   <source>Mean JaC at {tau:.1f} px over {frames}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>JaC medio a {tau:.1f} px en {frames}</translation>
  </message>
  <message>
   <source>Unreadable (filter camera:unreadable): {names}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Ilegibles (filtro camera:unreadable): {names}</translation>
  </message>
  <message numerus="yes">
   <source>{matched} of {total}, {n} unreadable</source>
   <extracomment>{matched} of {total}, {n} unreadable / {matched} of {total}, {n} unreadable [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{matched} de {total}, {n} ilegible</numerusform>
    <numerusform>{matched} de {total}, {n} ilegibles</numerusform>
   </translation>
  </message>
  <message>
   <source>Remove from the list; the files stay</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Quitar de la lista; los archivos quedan</translation>
  </message>
  <message>
   <source>Forget what was followed (T follows the shot again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Olvidar lo seguido (T sigue el plano otra vez)</translation>
  </message>
  <message>
   <source>Judge nothing, draw no camera</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>No juzgar nada, no dibujar ninguna cámara</translation>
  </message>
  <message>
   <source>Judge against {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Juzgar {name}</translation>
  </message>
  <message>
   <source>Remove {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Quitar {name}</translation>
  </message>
  <message>
   <source>Draw {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Dibujar {name}</translation>
  </message>
  <message>
   <source>Colour of {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Color de {name}</translation>
  </message>
  <message>
   <source>{frames} so far</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{frames} hasta ahora</translation>
  </message>
  <message numerus="yes">
   <source>{mean}; {n:,} cameras cannot be read and take no part</source>
   <extracomment>{mean}; {n:,} camera cannot be read and takes no part / {mean}; {n:,} cameras cannot be read and take no part [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{mean}; {n:,} cámara no se puede leer y no participa</numerusform>
    <numerusform>{mean}; {n:,} cámaras no se pueden leer y no participan</numerusform>
   </translation>
  </message>
  <message>
   <source>{model} (ground)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} (suelo)</translation>
  </message>
  <message>
   <source>{model} here</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} aquí</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames followed</source>
   <extracomment>{n:,} frame followed / {n:,} frames followed [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen seguida</numerusform>
    <numerusform>{n:,} imágenes seguidas</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} opened frames</source>
   <extracomment>{n:,} opened frame / {n:,} opened frames [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen abierta</numerusform>
    <numerusform>{n:,} imágenes abiertas</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ({share})</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{n} de {total} ({share})</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n:,} more</source>
   <extracomment>{names} and {n:,} more / {names} and {n:,} more [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{names} y {n:,} más</numerusform>
    <numerusform>{names} y {n:,} más</numerusform>
   </translation>
  </message>
  <message>
   <source>cannot be used here: {error}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>no se puede usar aquí: {error}</translation>
  </message>
  <message>
   <source>no camera for this frame</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>sin cámara para esta imagen</translation>
  </message>
  <message>
   <source>Other…</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Otro…</translation>
  </message>
  <message>
   <source>Colour of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Color de la fuente</translation>
  </message>
  <message>
   <source>Double-click or F2 gives it another name</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Doble clic o F2 le da otro nombre</translation>
  </message>
  <message>
   <source>Blind mode hides how the sources do</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>El modo ciego oculta cómo van las fuentes</translation>
  </message>
  <message>
   <source>No frame has both annotated elements and a camera of this source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Ninguna imagen tiene a la vez elementos anotados y una cámara de esta fuente</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} cameras</source>
   <extracomment>{n:,} camera / {n:,} cameras [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} cámara</numerusform>
    <numerusform>{n:,} cámaras</numerusform>
   </translation>
  </message>
  <message>
   <source>none judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>no juzgar ninguna</translation>
  </message>
  <message>
   <source>several models</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>varios modelos</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the setting protocol]</extracomment>
   <translation>soccernet (oficial)</translation>
  </message>
  <message>
   <source>procc (paper)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>procc (artículo)</translation>
  </message>
  <message>
   <source>count as missed</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>contar como fallados</translation>
  </message>
  <message>
   <source>are left out</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>se dejan fuera</translation>
  </message>
  <message>
   <source>Cameras ({endings});;All files (*)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cámaras ({endings});;Todos los archivos (*)</translation>
  </message>
  <message>
   <source>Source to compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Fuente con la que comparar</translation>
  </message>
  <message>
   <source>Compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Comparar con</translation>
  </message>
  <message>
   <source>{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>{share:.0f} % dentro de {far:g} m, en {covered:.0f} % de la imagen</translation>
  </message>
  <message>
   <source>No cameras loaded.
Load a folder of camera files or homographies to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>No hay cámaras cargadas.
Cargue una carpeta de archivos de cámara o de homografías para verlas juzgadas con sus clics.</translation>
  </message>
  <message>
   <source>Load folder…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cargar carpeta…</translation>
  </message>
  <message>
   <source>Load file…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cargar archivo…</translation>
  </message>
  <message>
   <source>Read as</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Leer como</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the menus, the setting protocol]</extracomment>
   <translation>Protocolo</translation>
  </message>
  <message>
   <source>Off the ground</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Fuera del suelo</translation>
  </message>
  <message>
   <source>This frame: {notice}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Esta imagen: {notice}</translation>
  </message>
  <message>
   <source>⚠ This frame's camera cannot be used: {error}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>⚠ La cámara de esta imagen no se puede usar: {error}</translation>
  </message>
  <message>
   <source>Held against the active source: comma, split view, disagreement</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Se contrapone a la fuente activa: coma, vista dividida, desacuerdo</translation>
  </message>
  <message>
   <source>min</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>mín.</translation>
  </message>
  <message>
   <source>median</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>mediana</translation>
  </message>
  <message>
   <source>max</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>máx.</translation>
  </message>
  <message>
   <source>on the ground, m</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>en el suelo, m</translation>
  </message>
  <message>
   <source>in the picture, px</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>en la imagen, px</translation>
  </message>
  <message>
   <source>A folder with one camera file a frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Una carpeta con un archivo de cámara por imagen</translation>
  </message>
  <message>
   <source>A zip archive of cameras, or the camera of one frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Un archivo zip de cámaras, o la cámara de una imagen</translation>
  </message>
  <message>
   <source>How the files loaded next are read</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Cómo se leen los próximos archivos que se carguen</translation>
  </message>
  <message>
   <source>soccernet: the official evaluation with its quirks
procc: the paper's definition, closed circles and fine curves</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>soccernet: la evaluación oficial con sus rarezas
procc: la definición del artículo, círculos cerrados y curvas finas</translation>
  </message>
  <message>
   <source>A homography knows the ground only: how posts and crossbars count for it</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Una homografía solo conoce el suelo: cómo cuentan para ella postes y travesaños</translation>
  </message>
  <message>
   <source>Between the two points on the ground that a pixel means</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Entre los dos puntos del suelo que significa un píxel</translation>
  </message>
  <message>
   <source>From a pixel to where the compared camera shows its ground point</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>De un píxel a donde la cámara comparada muestra su punto del suelo</translation>
  </message>
  <message>
   <source>annotated</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py, procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>anotado</translation>
  </message>
  <message>
   <source>unconfirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>sin confirmar</translation>
  </message>
  <message>
   <source>not visible</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>no visible</translation>
  </message>
  <message>
   <source>next</source>
   <comment>element</comment>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>siguiente</translation>
  </message>
  <message>
   <source>Not annotated in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>No anotado en esta imagen</translation>
  </message>
  <message>
   <source>Annotated, but not judged: no camera is shown, or it takes no part in the evaluation</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Anotado, pero no juzgado: no se muestra ninguna cámara, o no participa en la evaluación</translation>
  </message>
  <message>
   <source>Copied; it does not count until it is touched or confirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Copiado; no cuenta hasta que se toca o se confirma</translation>
  </message>
  <message>
   <source>Passes: all its points are closer than tau to the projection</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Pasa: todos sus puntos están más cerca de la proyección que tau</translation>
  </message>
  <message>
   <source>Too far: at least one point is tau or more away (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Demasiado lejos: al menos un punto está a tau o más (falso positivo)</translation>
  </message>
  <message>
   <source>The camera projects it, it is not annotated (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>La cámara lo proyecta, no está anotado (falso positivo)</translation>
  </message>
  <message>
   <source>Annotated, the camera does not project it (false negative)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Anotado, la cámara no lo proyecta (falso negativo)</translation>
  </message>
  <message>
   <source>Marked as not visible in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Alguien dijo que no se ve en esta imagen</translation>
  </message>
  <message>
   <source>To be annotated next, as on the field map and in the picture</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Por anotar a continuación, como en el mapa del campo y en la imagen</translation>
  </message>
  <message>
   <source>{title} (unknown class)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>{title} (clase desconocida)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Sin geometría</translation>
  </message>
  <message>
   <source>Unknown to the field (unknown classes)</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Desconocidas para el campo (clases desconocidas)</translation>
  </message>
  <message>
   <source>Find an element</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Buscar un elemento</translation>
  </message>
  <message>
   <source>No element matches “{query}”.
Esc clears the search.</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Ningún elemento coincide con «{query}».
Esc borra la búsqueda.</translation>
  </message>
  <message>
   <source>Annotated points</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Puntos anotados</translation>
  </message>
  <message>
   <source>{title}
Class in files: {name}</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>{title}
Clase en los archivos: {name}</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Elementos</translation>
  </message>
  <message>
   <source>Key</source>
   <comment>keyboard</comment>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Tecla</translation>
  </message>
  <message>
   <source>Pts</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Ptos.</translation>
  </message>
  <message>
   <source>Status</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Estado</translation>
  </message>
  <message>
   <source>Annotating it next helps most: the projection is then known to {after:.1f} px instead of {before:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Anotarlo ahora es lo que más aporta: la proyección se conocerá entonces hasta {after:.1f} px en vez de {before:.1f} px</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Mapa del campo</translation>
  </message>
  <message>
   <source>The arrows choose elements</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Las flechas eligen elementos</translation>
  </message>
  <message>
   <source>far</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>lejos</translation>
  </message>
  <message>
   <source>right</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>derecha</translation>
  </message>
  <message>
   <source>near</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>cerca</translation>
  </message>
  <message>
   <source>left</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>izquierda</translation>
  </message>
  <message>
   <source>Next: {title}, {before:.1f} → {after:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Siguiente: {title}, {before:.1f} → {after:.1f} px</translation>
  </message>
  <message>
   <source>Click an element</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Haga clic en un elemento</translation>
  </message>
  <message>
   <source>{shown:,} of {frames}</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>{shown:,} de {frames}</translation>
  </message>
  <message>
   <source>Show all frames</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py]</extracomment>
   <translation>Mostrar todas las imágenes</translation>
  </message>
  <message>
   <source>Error</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Error</translation>
  </message>
  <message>
   <source>Warning</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Aviso</translation>
  </message>
  <message>
   <source>Hint</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Indicio</translation>
  </message>
  <message>
   <source>Nothing found in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Nada hallado en esta imagen.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found in {n:,} frames.</source>
   <extracomment>Nothing found in {n:,} frame. / Nothing found in {n:,} frames. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Nada hallado en {n:,} imagen.</numerusform>
    <numerusform>Nada hallado en {n:,} imágenes.</numerusform>
   </translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures to check their labels.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>No hay imágenes.
Abra una carpeta de imágenes para revisar sus clases.</translation>
  </message>
  <message>
   <source>Nothing is annotated in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>No hay nada anotado en esta imagen.</translation>
  </message>
  <message>
   <source>No problems so far.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Ningún problema hasta ahora.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found but {n:,} ignored findings.</source>
   <extracomment>Nothing found but {n:,} ignored finding. / Nothing found but {n:,} ignored findings. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Nada hallado salvo {n:,} hallazgo ignorado.</numerusform>
    <numerusform>Nada hallado salvo {n:,} hallazgos ignorados.</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Ciego: los hallazgos que necesitan cámara esperan hasta entregar esta imagen (Ctrl+Intro).</translation>
  </message>
  <message>
   <source>The live fit is off: the full check needs it.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>El ajuste continuo está desactivado: la revisión completa lo necesita.</translation>
  </message>
  <message>
   <source>Full check needs a camera: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>La revisión completa necesita una cámara: {why}.</translation>
  </message>
  <message>
   <source>Blind: only committed frames are checked with a camera.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Ciego: solo las imágenes entregadas se revisan con una cámara.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked, such as {name}: {why}</source>
   <extracomment>{n:,} frame cannot be checked, such as {name}: {why} / {n:,} frames cannot be checked, such as {name}: {why} [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} imagen no se puede revisar, como {name}: {why}</numerusform>
    <numerusform>{n:,} imágenes no se pueden revisar, como {name}: {why}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>The set is not checked yet; {n:,} frames checked so far.</source>
   <extracomment>The set is not checked yet; {n:,} frame checked so far. / The set is not checked yet; {n:,} frames checked so far. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>El conjunto aún no está revisado; {n:,} imagen mirada hasta ahora.</numerusform>
    <numerusform>El conjunto aún no está revisado; {n:,} imágenes miradas hasta ahora.</numerusform>
   </translation>
  </message>
  <message>
   <source>List the findings of all checked frames, errors first, or of this frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Mostrar los hallazgos de todas las imágenes revisadas, errores primero, o los de esta imagen</translation>
  </message>
  <message>
   <source>Frames checked</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Imágenes revisadas</translation>
  </message>
  <message>
   <source>Checking this frame…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Revisando esta imagen…</translation>
  </message>
  <message>
   <source>Checking the set…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Revisando el conjunto…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} errors</source>
   <extracomment>{n:,} error / {n:,} errors [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} error</numerusform>
    <numerusform>{n:,} errores</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} warnings</source>
   <extracomment>{n:,} warning / {n:,} warnings [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} aviso</numerusform>
    <numerusform>{n:,} avisos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} hints</source>
   <extracomment>{n:,} hint / {n:,} hints [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} indicio</numerusform>
    <numerusform>{n:,} indicios</numerusform>
   </translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>Revisar todo el conjunto</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} more are not listed: switch the signs above on.</source>
   <extracomment>{n:,} more is not listed: switch the signs above on. / {n:,} more are not listed: switch the signs above on. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} más no se lista: active los signos de arriba.</numerusform>
    <numerusform>{n:,} más no se listan: active los signos de arriba.</numerusform>
   </translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action ignore_finding]</extracomment>
   <translation>No mostrarlo más hasta que cambien los puntos de sus elementos</translation>
  </message>
  <message>
   <source>Findings</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Hallazgos</translation>
  </message>
  <message>
   <source>Whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Todo el conjunto</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>Buscar clases equivocadas en todas las imágenes anotadas</translation>
  </message>
  <message>
   <source>Write the findings of all checked frames as CSV</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Escribir como CSV los hallazgos de todas las imágenes revisadas</translation>
  </message>
  <message>
   <source>{findings}; click to list them or not</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>{findings}; clic para listarlos o no</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt;</source>
   <extracomment>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; / {n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} ignorado aquí. &lt;a href="restore"&gt;Mostrar de nuevo&lt;/a&gt;</numerusform>
    <numerusform>{n:,} ignorados aquí. &lt;a href="restore"&gt;Mostrar de nuevo&lt;/a&gt;</numerusform>
   </translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/menus.py, the action ignore_finding]</extracomment>
   <translation>Ignorar este hallazgo</translation>
  </message>
  <message>
   <source>Mean</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Media</translation>
  </message>
  <message>
   <source>Largest</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Mayor</translation>
  </message>
  <message>
   <source>Worst first; a click shows the worst point</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Los peores primero; un clic muestra el peor punto</translation>
  </message>
  <message>
   <source>Mean distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distancia media de sus puntos al elemento ajustado, px de la imagen</translation>
  </message>
  <message>
   <source>Largest distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Mayor distancia de sus puntos al elemento ajustado, px de la imagen</translation>
  </message>
  <message>
   <source>{model}. Chosen: {why}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{model}. Elegido: {why}</translation>
  </message>
  <message numerus="yes">
   <source>{passing} of {n:,} annotated elements within {px:g} px</source>
   <extracomment>{passing} of {n:,} annotated element within {px:g} px / {passing} of {n:,} annotated elements within {px:g} px [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{passing} de {n:,} elemento anotado dentro de {px:g} px</numerusform>
    <numerusform>{passing} de {n:,} elementos anotados dentro de {px:g} px</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{counted}; {n} in sight not annotated yet</source>
   <extracomment>{counted}; {n} in sight not annotated yet / {counted}; {n} in sight not annotated yet [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{counted}; {n} a la vista aún sin anotar</numerusform>
    <numerusform>{counted}; {n} a la vista aún sin anotar</numerusform>
   </translation>
  </message>
  <message>
   <source>{title}: mean {mean} px, largest {largest} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{title}: media {mean} px, mayor {largest} px</translation>
  </message>
  <message>
   <source>Taken for a mistake: it had no say in the fit</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Tomado por un error: no contó en el ajuste</translation>
  </message>
  <message>
   <source>Elements in sight that are not annotated count against the JaC</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Los elementos a la vista que no están anotados cuentan contra el JaC</translation>
  </message>
  <message>
   <source>Hardly determined: {limits}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Apenas determinado: {limits}</translation>
  </message>
  <message>
   <source>Mean distance of the points that had a say, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distancia media de los puntos que contaron, px de la imagen</translation>
  </message>
  <message>
   <source>Standard deviation, as the fit estimates it</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Desviación típica, según la estima el ajuste</translation>
  </message>
  <message>
   <source>Save as the frame's camera</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Guardar como cámara de la imagen</translation>
  </message>
  <message>
   <source>✕ left out: {title}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>✕ dejado fuera: {title}</translation>
  </message>
  <message>
   <source>Pan</source>
   <comment>an angle</comment>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Giro</translation>
  </message>
  <message>
   <source>Tilt</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Inclinación</translation>
  </message>
  <message>
   <source>Roll</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Alabeo</translation>
  </message>
  <message>
   <source>Focal length</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Distancia focal</translation>
  </message>
  <message>
   <source>Along (x)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>A lo largo (x)</translation>
  </message>
  <message>
   <source>Across (y)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>A lo ancho (y)</translation>
  </message>
  <message>
   <source>Height (−z)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Altura (−z)</translation>
  </message>
  <message>
   <source>Model</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Modelo</translation>
  </message>
  <message>
   <source>Residuals by element</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Residuos por elemento</translation>
  </message>
  <message>
   <source>No camera yet: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Aún no hay cámara: {why}.</translation>
  </message>
  <message>
   <source>Fitting the clicks…</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Ajustando los clics…</translation>
  </message>
  <message>
   <source>No fit.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Sin ajuste.</translation>
  </message>
  <message>
   <source>JaC at {tau:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py, procc_annotator/gui/panels/plots/pages.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC a {tau:.1f} px</translation>
  </message>
  <message>
   <source>&lt;b&gt;Hardly determined&lt;/b&gt;: {what}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>&lt;b&gt;Apenas determinado&lt;/b&gt;: {what}</translation>
  </message>
  <message>
   <source>JaC: {terms}; residuals: px of the picture, {width}x{height}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>JaC: {terms}; residuos: px de la imagen, {width}x{height}</translation>
  </message>
  <message>
   <source>What is fitted. Automatically: the simplest model that the clicks support</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Qué se ajusta. Automáticamente: el modelo más sencillo que permiten los clics</translation>
  </message>
  <message>
   <source>mean residual</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>residuo medio</translation>
  </message>
  <message numerus="yes">
   <source>{n} open</source>
   <extracomment>{n} open / {n} open [procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n} abierto</numerusform>
    <numerusform>{n} abiertos</numerusform>
   </translation>
  </message>
  <message>
   <source>all done</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>todas terminadas</translation>
  </message>
  <message>
   <source>not annotated</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>sin anotar</translation>
  </message>
  <message>
   <source>⚠ unreadable</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ ilegible</translation>
  </message>
  <message>
   <source>⚠ camera</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ cámara</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} done</source>
   <extracomment>{n:,} done / {n:,} done [procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>
    <numerusform>{n:,} terminada</numerusform>
    <numerusform>{n:,} terminadas</numerusform>
   </translation>
  </message>
  <message>
   <source>● not saved</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>● sin guardar</translation>
  </message>
  <message>
   <source>the picture cannot be read</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>la imagen no se puede leer</translation>
  </message>
  <message>
   <source>mean JaC {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>JaC medio {jac:.3f}</translation>
  </message>
  <message>
   <source>folded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>plegada</translation>
  </message>
  <message>
   <source>unfolded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>desplegada</translation>
  </message>
  <message>
   <source>Filter frames</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Filtrar imágenes</translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures (jpg, png, bmp, webp), or drop one here.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>No hay imágenes.
Abra una carpeta de imágenes (jpg, png, bmp, webp), o suelte una aquí.</translation>
  </message>
  <message>
   <source>Nothing matches “{query}”.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Nada coincide con «{query}».</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} folders</source>
   <extracomment>{frames} in {n:,} folder / {frames} in {n:,} folders [procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>
    <numerusform>{frames} en {n:,} carpeta</numerusform>
    <numerusform>{frames} en {n:,} carpetas</numerusform>
   </translation>
  </message>
  <message>
   <source>No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the corner of a board, a floodlight. Name one below, and click it in two calibrated views.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>No hay marcas. Una marca es un lugar de este estadio que el campo no tiene: un asiento, la esquina de una valla, un foco. Dé nombre a una abajo y haga clic en ella en dos vistas calibradas.</translation>
  </message>
  <message>
   <source>Find its place from the views it is clicked in; cameras are those of the active source, else fits to the clicks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Hallar su lugar con las vistas en que está marcado; las cámaras son las de la fuente activa o, si no, ajustes a los clics</translation>
  </message>
  <message>
   <source>Other views of this instant</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Otras vistas de este instante</translation>
  </message>
  <message>
   <source>No other views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>No hay otras vistas</translation>
  </message>
  <message>
   <source>Its place cannot be brought back with undo. Clicks on it stay in the annotations.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Su lugar no se puede recuperar con deshacer. Los clics quedan en las anotaciones.</translation>
  </message>
  <message>
   <source>Landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Marca</translation>
  </message>
  <message>
   <source>Views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Vistas</translation>
  </message>
  <message>
   <source>Triangulated from {frames}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangulado con {frames}</translation>
  </message>
  <message>
   <source>Other views of this instant: go to one with a click</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Otras vistas de este instante: ir a una con un clic</translation>
  </message>
  <message>
   <source>{title} is clicked in no frame yet: click it in two calibrated views to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} aún no está marcado en ninguna imagen: márquelo en dos vistas calibradas para triangularlo.</translation>
  </message>
  <message>
   <source>Clicked here, but no landmarks yet: {names}. Write a name next to Add to triangulate it.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Con clics aquí, pero aún no son marcas: {names}. Escriba un nombre junto a Añadir para triangularlas.</translation>
  </message>
  <message>
   <source>Its place is not known yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Su lugar aún no se conoce</translation>
  </message>
  <message>
   <source>Surveyed</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Medido en el terreno</translation>
  </message>
  <message>
   <source>New landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Nueva marca</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/panels/review.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Añadir</translation>
  </message>
  <message>
   <source>What people call it</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Cómo la llama la gente</translation>
  </message>
  <message>
   <source>x, y, z in metres, z down</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>x, y, z en metros, z hacia abajo</translation>
  </message>
  <message>
   <source>Set</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Fijar</translation>
  </message>
  <message>
   <source>Triangulate</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangular</translation>
  </message>
  <message>
   <source>Standard deviation in the direction where it is largest</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Desviación típica en la dirección en que es mayor</translation>
  </message>
  <message>
   <source>{name} is being triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{name} se está triangulando.</translation>
  </message>
  <message>
   <source>{why}. Delete the landmark and name it again to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{why}. Borre la marca y nómbrela de nuevo para triangularla.</translation>
  </message>
  <message>
   <source>Looking for the frames in which {title} is clicked…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Buscando las imágenes en que {title} está marcado…</translation>
  </message>
  <message>
   <source>{title} is clicked in {frame} alone: click it in another calibrated view to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} solo está marcado en {frame}: márquelo en otra vista calibrada para triangularlo.</translation>
  </message>
  <message>
   <source>Choose a landmark in the list to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Elija una marca de la lista para triangularla.</translation>
  </message>
  <message>
   <source>Only a landmark that has a name can be triangulated: write one next to Add.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Solo se puede triangular una marca con nombre: escríbalo junto a Añadir.</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n} more</source>
   <extracomment>{names} and {n} more / {names} and {n} more [procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>
    <numerusform>{names} y {n} más</numerusform>
    <numerusform>{names} y {n} más</numerusform>
   </translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Marcas</translation>
  </message>
  <message>
   <source>Have a new landmark, to be clicked (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Crear una nueva marca para hacer clic en ella (Intro)</translation>
  </message>
  <message>
   <source>The place was measured: it stays as it is from now on (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>El lugar se midió: desde ahora queda como está (Intro)</translation>
  </message>
  <message>
   <source>Forget this landmark; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Olvidar esta marca; los clics quedan en las anotaciones</translation>
  </message>
  <message>
   <source>Title</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Título</translation>
  </message>
  <message>
   <source>Place</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Lugar</translation>
  </message>
  <message>
   <source>Not clicked in any frame yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Aún no marcado en ninguna imagen</translation>
  </message>
  <message>
   <source>Triangulating…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangulando…</translation>
  </message>
  <message>
   <source>a landmark needs a name: write one next to Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>una marca necesita un nombre: escríbalo junto a Añadir</translation>
  </message>
  <message>
   <source>deleted the landmark {title}; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>marca {title} borrada; los clics quedan en las anotaciones</translation>
  </message>
  <message>
   <source>the landmark {title}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>la marca {title}</translation>
  </message>
  <message>
   <source>Picture (*.png);;Vector graphics (*.svg)</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Imagen (*.png);;Gráfico vectorial (*.svg)</translation>
  </message>
  <message>
   <source>the plotted numbers are on the clipboard</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>los números del gráfico están en el portapapeles</translation>
  </message>
  <message>
   <source>Save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Guardar el gráfico</translation>
  </message>
  <message>
   <source>wrote {path}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} escrito, hasta donde está puntuado</translation>
  </message>
  <message>
   <source>wrote {path}</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} escrito</translation>
  </message>
  <message>
   <source>the plot is on the clipboard as a picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>el gráfico está en el portapapeles como imagen</translation>
  </message>
  <message>
   <source>there is nothing plotted to take along</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>no hay nada trazado que llevarse</translation>
  </message>
  <message>
   <source>{frames}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{frames}, hasta donde está puntuado</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows committed frames only, and none of them is in this plot.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Oculto: el modo ciego solo muestra imágenes entregadas, y ninguna está en este gráfico.</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows this plot once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Oculto: el modo ciego muestra este gráfico una vez entregada esta imagen.</translation>
  </message>
  <message>
   <source>Sources: {names}</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Fuentes: {names}</translation>
  </message>
  <message>
   <source>Shots are recognized by names, since {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Los planos se reconocen por los nombres, pues {error}.</translation>
  </message>
  <message>
   <source>JaC over tau</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC según tau</translation>
  </message>
  <message>
   <source>JaC over the frames</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC por imágenes</translation>
  </message>
  <message>
   <source>No scores yet. They are computed in the background, frame by frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aún no hay puntuaciones. Se calculan en segundo plano, imagen por imagen.</translation>
  </message>
  <message>
   <source>Errors, as a histogram</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Errores, como histograma</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points without a distance left out.</source>
   <extracomment>{n:,} point without a distance left out. / {n:,} points without a distance left out. [procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>
    <numerusform>{n:,} punto sin distancia dejado fuera.</numerusform>
    <numerusform>{n:,} puntos sin distancia dejados fuera.</numerusform>
   </translation>
  </message>
  <message>
   <source>Residuals over the picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Residuos sobre la imagen</translation>
  </message>
  <message>
   <source>tau (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau (px)</translation>
  </message>
  <message>
   <source>frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>imagen</translation>
  </message>
  <message>
   <source>{name} (frame {n})</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} (imagen {n})</translation>
  </message>
  <message>
   <source>No score of this frame: it is not annotated, or no shown source has its camera.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Sin puntuación de esta imagen: no está anotada, o ninguna fuente mostrada tiene su cámara.</translation>
  </message>
  <message>
   <source>reprojection error (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>error de reproyección (px)</translation>
  </message>
  <message>
   <source>points</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>puntos</translation>
  </message>
  <message>
   <source>How many times longer than they are arrows are drawn</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Cuántas veces más largas de lo que son se dibujan las flechas</translation>
  </message>
  <message>
   <source>Arrows drawn longer</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flechas dibujadas más largas</translation>
  </message>
  <message>
   <source>The last bar holds all larger errors.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>La última barra reúne todos los errores mayores.</translation>
  </message>
  <message>
   <source>{px:g} px or more</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{px:g} px o más</translation>
  </message>
  <message>
   <source>{name} {part:,} of {total:,}</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} {part:,} de {total:,}</translation>
  </message>
  <message>
   <source>No point of {element} in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Ningún punto de {element} en esta imagen.</translation>
  </message>
  <message>
   <source>No point of {element} so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Ningún punto de {element} hasta ahora.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Ningún punto anotado en esta imagen que proyecte una fuente mostrada.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Hasta ahora ningún punto anotado que proyecte una fuente mostrada.</translation>
  </message>
  <message>
   <source>automatic</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>automático</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: from the click towards the projection.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flechas {factor} veces más largas de lo que son: del clic hacia la proyección.</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: the median residual of each part of the picture with 5 points or more.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Flechas {factor} veces más largas de lo que son: el residuo mediano de cada parte de la imagen con 5 puntos o más.</translation>
  </message>
  <message>
   <source>Each curve is the mean of the frames that source has a camera for.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Cada curva es la media de las imágenes para las que esa fuente tiene cámara.</translation>
  </message>
  <message>
   <source>Shaded: 95 % bands, {drawn}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Sombreado: bandas del 95 %, {drawn}.</translation>
  </message>
  <message>
   <source>tau {px:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau {px:.1f} px</translation>
  </message>
  <message>
   <source>Too few points so far: five in a part of the picture make an arrow.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Aún pocos puntos: cinco en una parte de la imagen hacen una flecha.</translation>
  </message>
  <message>
   <source>This frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Esta imagen</translation>
  </message>
  <message>
   <source>Copy or save the plot and its numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copiar o guardar el gráfico y sus números</translation>
  </message>
  <message>
   <source>Plot the points of one element only</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Trazar solo los puntos de un elemento</translation>
  </message>
  <message>
   <source>({n:,} of {total:,})</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} de {total:,})</translation>
  </message>
  <message>
   <source>All elements</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Todos los elementos</translation>
  </message>
  <message>
   <source>Plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Gráfico</translation>
  </message>
  <message>
   <source>This plot could not be computed: {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Este gráfico no se pudo calcular: {error}.</translation>
  </message>
  <message>
   <source>({n:,} committed)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} entregadas)</translation>
  </message>
  <message>
   <source>Copy or save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copiar o guardar el gráfico</translation>
  </message>
  <message>
   <source>Copy picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copiar imagen</translation>
  </message>
  <message>
   <source>Copy numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Copiar números</translation>
  </message>
  <message>
   <source>Save picture…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Guardar imagen…</translation>
  </message>
  <message>
   <source>Save numbers…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Guardar números…</translation>
  </message>
  <message>
   <source>Plot the frame on screen, or all frames scored so far</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Trazar la imagen en pantalla, o todas las puntuadas hasta ahora</translation>
  </message>
  <message>
   <source>Computing…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Calculando…</translation>
  </message>
  <message>
   <source>(hidden)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(oculto)</translation>
  </message>
  <message>
   <source>(no score)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(sin puntuación)</translation>
  </message>
  <message>
   <source>Save</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Guardar</translation>
  </message>
  <message>
   <source>Committed in blind mode, and as it was then.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Entregada en modo ciego, y como estaba entonces.</translation>
  </message>
  <message>
   <source>Edited after the cameras were shown.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Editada después de mostrarse las cámaras.</translation>
  </message>
  <message>
   <source>{seconds} s</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{seconds} s</translation>
  </message>
  <message>
   <source>How the points of this frame came to be</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Cómo surgieron los puntos de esta imagen</translation>
  </message>
  <message>
   <source>Add the comment to the thread (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Añadir el comentario al hilo (Intro)</translation>
  </message>
  <message>
   <source>Committed in blind mode by {author}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Entregada en modo ciego por {author}</translation>
  </message>
  <message>
   <source>{minutes}:{seconds:02d} min</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{minutes}:{seconds:02d} min</translation>
  </message>
  <message>
   <source>This frame is right (Ctrl+Shift+A)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Esta imagen está bien (Ctrl+Mayús+A)</translation>
  </message>
  <message>
   <source>Send it back (Ctrl+Shift+X)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Devolverla (Ctrl+Mayús+X)</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[procc_annotator/gui/panels/review.py, the action reject]</extracomment>
   <translation>Rechazar</translation>
  </message>
  <message>
   <source>No comments on this frame.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>No hay comentarios sobre esta imagen.</translation>
  </message>
  <message>
   <source>Comment on this place</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Comentario sobre este lugar</translation>
  </message>
  <message>
   <source>{frame} is {status}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{frame} está {status}</translation>
  </message>
  <message>
   <source>{frame} is {status} again</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} vuelve a estar {status}</translation>
  </message>
  <message>
   <source>Time worked on this frame; pauses over 30 s do not count</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Tiempo trabajado en esta imagen; las pausas de más de 30 s no cuentan</translation>
  </message>
  <message>
   <source>Comments</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Comentarios</translation>
  </message>
  <message>
   <source>Points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Puntos: {kinds}</translation>
  </message>
  <message>
   <source>Points: none</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Puntos: ninguno</translation>
  </message>
  <message numerus="yes">
   <source>to be confirmed (Shift+V): {n:,} elements</source>
   <extracomment>to be confirmed (Shift+V): {n:,} element / to be confirmed (Shift+V): {n:,} elements [procc_annotator/gui/panels/review.py]</extracomment>
   <translation>
    <numerusform>por confirmar (Mayús+V): {n:,} elemento</numerusform>
    <numerusform>por confirmar (Mayús+V): {n:,} elementos</numerusform>
   </translation>
  </message>
  <message>
   <source>Comment on this frame</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Comentario sobre esta imagen</translation>
  </message>
  <message>
   <source>Ticked: settled</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Marcado: resuelto</translation>
  </message>
  <message>
   <source>somebody</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/editing/batch_edits.py, procc_annotator/gui/state/state.py]</extracomment>
   <translation>alguien</translation>
  </message>
  <message>
   <source>Choose an element to read why it counts as it does.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elija un elemento para leer por qué cuenta como cuenta.</translation>
  </message>
  <message>
   <source>the camera is the fit to these same clicks: this JaC is no score of a method</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>la cámara es el ajuste a estos mismos clics: este JaC no puntúa ningún método</translation>
  </message>
  <message>
   <source>Mirrored labels count here: the field turned by 180° fits at least as well.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Aquí cuentan las clases reflejadas: el campo girado 180° encaja al menos igual de bien.</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>ruido humano {median:.2f} px, 95 % dentro de {p95:.2f} px</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>ruido humano {median:.2f} px, 95 % dentro de {p95:.2f} px – más que tau</translation>
  </message>
  <message>
   <source>Point</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Punto</translation>
  </message>
  <message>
   <source>Worst</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Peor</translation>
  </message>
  <message>
   <source>Passes at</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Pasa a</translation>
  </message>
  <message>
   <source>Click a row to see the point that decides</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Haga clic en una fila para ver el punto que decide</translation>
  </message>
  <message>
   <source>How the element counts at tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Cómo cuenta el elemento con tau</translation>
  </message>
  <message>
   <source>The point that decides, counted from 1</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>El punto que decide, contado desde 1</translation>
  </message>
  <message>
   <source>Largest distance of its points to the projection, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mayor distancia de sus puntos a la proyección, px</translation>
  </message>
  <message>
   <source>The smallest tau of the slider at which it passes, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>El menor tau del control con que pasa, px</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Cámara errónea</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Anotación errónea</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>La cámara activa está mal en esta imagen</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Los clics están mal en esta imagen</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>La cámara y los clics están bien en esta imagen</translation>
  </message>
  <message>
   <source>What causes the score of this frame; saved with the dataset</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>De quién es el fallo de la puntuación de esta imagen; se conserva con el conjunto</translation>
  </message>
  <message>
   <source>Precision</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Precisión</translation>
  </message>
  <message>
   <source>Recall</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Exhaustividad</translation>
  </message>
  <message>
   <source>Mean error</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Error medio</translation>
  </message>
  <message>
   <source>Mean reprojection error of all points, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Error medio de reproyección de todos los puntos, px</translation>
  </message>
  <message>
   <source>Median reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mediana del error de reproyección, px</translation>
  </message>
  <message>
   <source>Max</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Máx.</translation>
  </message>
  <message>
   <source>Largest reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mayor error de reproyección, px</translation>
  </message>
  <message>
   <source>{name} has no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{name} no tiene cámara para esta imagen.</translation>
  </message>
  <message>
   <source>points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>puntos: {kinds}</translation>
  </message>
  <message>
   <source>{verdict}; once more takes it back ({key})</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{verdict}; otra vez lo retira ({key})</translation>
  </message>
  <message>
   <source>Verdict: {verdict}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Veredicto: {verdict}</translation>
  </message>
  <message>
   <source>Scores by element</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Puntuación por elemento</translation>
  </message>
  <message>
   <source>Copy this explanation</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Copiar esta explicación</translation>
  </message>
  <message>
   <source>Copy all explanations</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Copiar todas las explicaciones</translation>
  </message>
  <message>
   <source>JaC –: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC –: {why}.</translation>
  </message>
  <message>
   <source>This frame's camera cannot be used:
{error}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>La cámara de esta imagen no se puede usar:
{error}</translation>
  </message>
  <message>
   <source>No fit to judge: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>No hay ajuste que juzgar: {why}.</translation>
  </message>
  <message>
   <source>Counts as {class_name}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Cuenta como {class_name}</translation>
  </message>
  <message>
   <source>Verdict</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Veredicto</translation>
  </message>
  <message>
   <source>Elements whose points all are closer than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elementos cuyos puntos están todos más cerca que tau</translation>
  </message>
  <message>
   <source>Elements too far, or projected and not annotated</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elementos demasiado lejos, o proyectados y no anotados</translation>
  </message>
  <message>
   <source>Annotated elements that the camera does not project</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elementos anotados que la cámara no proyecta</translation>
  </message>
  <message>
   <source>anchor</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ancla</translation>
  </message>
  <message>
   <source>followed</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>seguida</translation>
  </message>
  <message>
   <source>bridged</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>puenteada</translation>
  </message>
  <message>
   <source>lost</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>perdida</translation>
  </message>
  <message>
   <source>frame {number} of {first}–{last}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>imagen {number} de {first}–{last}</translation>
  </message>
  <message>
   <source>{state}, {share:.0%} of the lines on paint</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{state}, {share:.0%} de las líneas sobre pintura</translation>
  </message>
  <message>
   <source>names count by {step}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>los nombres cuentan de {step} en {step}</translation>
  </message>
  <message>
   <source>its camera was dragged</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>su cámara se arrastró</translation>
  </message>
  <message>
   <source>blind: its camera is hidden</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ciego: su cámara está oculta</translation>
  </message>
  <message>
   <source>{found}, {far:.1f} px from it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{found}, a {far:.1f} px</translation>
  </message>
  <message>
   <source>doubtful: {why}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>dudosa: {why}</translation>
  </message>
  <message>
   <source>Frames of the shot</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Imágenes del plano</translation>
  </message>
  <message>
   <source>The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Las flechas van de imagen en imagen, con Mayús marcan un tramo, Esc lo olvida</translation>
  </message>
  <message>
   <source>not {number:g}: {least:g} to {most:g}{unit}</source>
   <extracomment>[procc_annotator/gui/panels/widgets.py]</extracomment>
   <translation>{number:g} no: de {least:g} a {most:g}{unit}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Ajuste y fantasmas</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Anotación</translation>
  </message>
  <message>
   <source>blind: the camera is hidden until this frame is committed (Ctrl+Enter)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>ciego: la cámara está oculta hasta entregar esta imagen (Ctrl+Intro)</translation>
  </message>
  <message>
   <source>load cameras first: there is nothing to score</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>cargue cámaras primero: no hay nada que puntuar</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>abra primero una carpeta de imágenes</translation>
  </message>
  <message>
   <source>choose the camera to judge first (C)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>elija primero la cámara que se juzga (C)</translation>
  </message>
  <message>
   <source>the live fit is off (Ctrl+T)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>el ajuste continuo está desactivado (Ctrl+T)</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>unexpected error ({what})</source>
   <extracomment>[procc_annotator/gui/state/background.py]</extracomment>
   <translation>error inesperado ({what})</translation>
  </message>
  <message>
   <source>expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>se esperaban archivos como camera_00037.json, 00037.npy o 00037.homographyMatrix</translation>
  </message>
  <message>
   <source>load one of its folders: {names}</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>cargue una de sus carpetas: {names}</translation>
  </message>
  <message>
   <source>it holds the same already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>ya contiene lo mismo</translation>
  </message>
  <message>
   <source>it is annotated already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>ya está anotada</translation>
  </message>
  <message>
   <source>{who} is editing it</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>{who} la está editando</translation>
  </message>
  <message>
   <source>it cannot be edited</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>no se puede editar</translation>
  </message>
  <message>
   <source>blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked after that is no blind work</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>ciego: aquí no hay nada anotado; Ctrl+Intro otra vez muestra las cámaras, y lo que se marque después no es trabajo a ciegas</translation>
  </message>
  <message>
   <source>{frame} is done</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} está terminada</translation>
  </message>
  <message>
   <source>nothing to undo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>nada que deshacer en esta imagen</translation>
  </message>
  <message>
   <source>undo once more takes that away</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>deshacer otra vez lo quita</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere and read again: {so}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} se cambió en otra parte y se leyó de nuevo: {so}</translation>
  </message>
  <message>
   <source>unconfirmed elements do not count: {count}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>los elementos sin confirmar no cuentan: {count}</translation>
  </message>
  <message>
   <source>undone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>deshecho: {step}</translation>
  </message>
  <message>
   <source>redone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rehecho: {step}</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} se cambió en otra parte: leída de nuevo</translation>
  </message>
  <message>
   <source>nothing is undone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>no se deshace nada</translation>
  </message>
  <message>
   <source>nothing is redone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>no se rehace nada</translation>
  </message>
  <message>
   <source>nothing to redo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>nada que rehacer en esta imagen</translation>
  </message>
  <message>
   <source>cameras of {name} changed: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>las cámaras de {name} cambiaron: {why}</translation>
  </message>
  <message>
   <source>cameras of {name} changed on disk: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>las cámaras de {name} cambiaron en disco: leídas de nuevo</translation>
  </message>
  <message>
   <source>not saved: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/saving.py]</extracomment>
   <translation>no guardado: {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks stay as they were: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>las marcas del conjunto quedan como estaban: {why}</translation>
  </message>
  <message>
   <source>{title} is at {place} m, ± {deviations}, from {views} views</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} está en {place} m, ± {deviations}, con {views} vistas</translation>
  </message>
  <message>
   <source>{title} was deleted meanwhile: its place was not kept</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} se borró entretanto: su lugar no se conservó</translation>
  </message>
  <message>
   <source>left out: {names}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>dejados fuera: {names}</translation>
  </message>
  <message>
   <source>the dataset's landmarks are not used: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>las marcas del conjunto no se usan: {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks can be used again</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>las marcas del conjunto se pueden usar otra vez</translation>
  </message>
  <message>
   <source>{names} share only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} solo dicen dónde se ven los elementos, sin cámara: no hay suelo que comparar.</translation>
  </message>
  <message>
   <source>{names}: no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names}: sin cámara para esta imagen.</translation>
  </message>
  <message>
   <source>{name} shares only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{name} solo dice dónde se ven los elementos, sin cámara: no hay suelo que comparar.</translation>
  </message>
  <message>
   <source>{a} and {b}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{a} y {b}</translation>
  </message>
  <message>
   <source>The two see no part of the field in common in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Las dos no ven ninguna parte común del campo en esta imagen.</translation>
  </message>
  <message>
   <source>Both cameras are the same in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Las dos cámaras son iguales en esta imagen.</translation>
  </message>
  <message>
   <source>No source is judged: choose one first.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>No se juzga ninguna fuente: elija una primero.</translation>
  </message>
  <message>
   <source>Two sources of cameras are needed: load another one.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Hacen falta dos fuentes de cámaras: cargue otra.</translation>
  </message>
  <message>
   <source>The fitted camera sees no part of the field.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>La cámara ajustada no ve ninguna parte del campo.</translation>
  </message>
  <message>
   <source>There is no fit of this frame, so no uncertainty map.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>No hay ajuste de esta imagen, así que no hay mapa de incertidumbre.</translation>
  </message>
  <message>
   <source>No camera yet, so no uncertainty map: {why}.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Aún no hay cámara, así que no hay mapa de incertidumbre: {why}.</translation>
  </message>
  <message>
   <source>the painted width cannot be drawn: {why}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>no se puede dibujar la anchura pintada: {why}</translation>
  </message>
  <message>
   <source>{file} says what the field of this dataset is: to choose another one, move that file away and open the dataset again</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>{file} dice cuál es el campo de este conjunto: para elegir otro, aparte ese archivo y abra el conjunto de nuevo</translation>
  </message>
  <message>
   <source>field: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>campo: {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>el campo de este conjunto desde ahora: {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on, {reach}: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>el campo de este conjunto desde ahora, {reach}: {field}</translation>
  </message>
  <message>
   <source>no other field knows the classes here better</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>ningún otro campo conoce mejor estas clases</translation>
  </message>
  <message>
   <source>{folder} cannot be written: what is annotated here has to be saved elsewhere (File &gt; Save copies to…)</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>no se puede escribir en {folder}: lo que se anote aquí debe guardarse en otra parte (Archivo &gt; Guardar copias en…)</translation>
  </message>
  <message>
   <source>not everything is saved yet: the other dataset was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>aún no está todo guardado: el otro conjunto no se abrió</translation>
  </message>
  <message>
   <source>not everything is saved yet: the video was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>aún no está todo guardado: el vídeo no se abrió</translation>
  </message>
  <message>
   <source>nothing is open</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>no hay nada abierto</translation>
  </message>
  <message>
   <source>unfinished elements were kept: {titles}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>se conservan elementos sin terminar: {titles}</translation>
  </message>
  <message>
   <source>the field of this dataset: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>el campo de este conjunto: {field}</translation>
  </message>
  <message>
   <source>the filter shows no further frame this way</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>el filtro no muestra más imágenes en este sentido</translation>
  </message>
  <message>
   <source>you rejected it (Ctrl+Z takes that back)</source>
   <extracomment>[procc_annotator/gui/state/prediction/camera_choice.py]</extracomment>
   <translation>usted la rechazó (Ctrl+Z lo deshace)</translation>
  </message>
  <message>
   <source>draw 3 elements, two of which meet, such as {names}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>dibuje 3 elementos, dos de ellos que se crucen, como {names}</translation>
  </message>
  <message>
   <source>{title}: its line could not be looked for: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>{title}: no se pudo buscar su línea: {why}</translation>
  </message>
  <message>
   <source>chosen automatically</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>elegido automáticamente</translation>
  </message>
  <message>
   <source>H: homography of the ground</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>H: homografía del suelo</translation>
  </message>
  <message>
   <source>P: pinhole</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>P: estenopeica</translation>
  </message>
  <message>
   <source>R: pinhole, lens distortion</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R: estenopeica, distorsión de lente</translation>
  </message>
  <message>
   <source>R+: R, aspect ratio, principal point</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R+: R, relación de aspecto, punto principal</translation>
  </message>
  <message>
   <source>R2: R+, second radial coefficient</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R2: R+, segundo coeficiente radial</translation>
  </message>
  <message>
   <source>F: fisheye</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>F: ojo de pez</translation>
  </message>
  <message>
   <source>the fit failed: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py]</extracomment>
   <translation>el ajuste falló: {why}</translation>
  </message>
  <message>
   <source>{who} unlocked this dataset from blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} levantó el modo ciego de este conjunto el {day}</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} estaba {status} y vuelve a estar en curso</translation>
  </message>
  <message>
   <source>for you alone: the dataset's folder cannot be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>solo para usted: no se puede escribir en la carpeta del conjunto</translation>
  </message>
  <message>
   <source>{reason}: there is no live fit in it</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}: no hay ajuste continuo en él</translation>
  </message>
  <message>
   <source>This dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Este conjunto está fijado en modo ciego</translation>
  </message>
  <message>
   <source>Somebody</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Alguien</translation>
  </message>
  <message>
   <source>{who} locked this dataset to blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} fijó este conjunto en modo ciego el {day}</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again: edited after the cameras were shown, it is no blind work any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} estaba {status} y vuelve a estar en curso: editada después de mostrarse las cámaras, ya no es trabajo a ciegas</translation>
  </message>
  <message>
   <source>in this window only: nothing can be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>solo en esta ventana: no se puede escribir nada</translation>
  </message>
  <message>
   <source>this dataset is not locked to blind mode any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>este conjunto ya no está fijado en modo ciego</translation>
  </message>
  <message>
   <source>{reason}: menu Frame unlocks it, which is recorded</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}: el menú Imagen lo levanta, y queda registrado</translation>
  </message>
  <message>
   <source>this dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>este conjunto está fijado en modo ciego</translation>
  </message>
  <message>
   <source>{path}: no camera has the name of a frame (cameras are named like {camera!r}, frames like {frame!r})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}: ninguna cámara tiene el nombre de una imagen (las cámaras se llaman como {camera!r}, las imágenes como {frame!r})</translation>
  </message>
  <message>
   <source>{path}: no cameras in it ({what_to_do})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}: no hay cámaras dentro ({what_to_do})</translation>
  </message>
  <message numerus="yes">
   <source>no class of this field: {n} labels ({names})</source>
   <extracomment>no class of this field: {n} label ({names}) / no class of this field: {n} labels ({names}) [procc_annotator/gui/state/second.py]</extracomment>
   <translation>
    <numerusform>sin clase en este campo: {n} etiqueta ({names})</numerusform>
    <numerusform>sin clase en este campo: {n} etiquetas ({names})</numerusform>
   </translation>
  </message>
  <message>
   <source>{path}: holds no annotation (*.json)</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>{path}: no contiene ninguna anotación (*.json)</translation>
  </message>
  <message>
   <source>second annotator: {why}</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>segundo anotador: {why}</translation>
  </message>
  <message>
   <source>{who} is editing it; it opens by itself once they leave it</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} la está editando; se abre sola en cuanto la deje</translation>
  </message>
  <message>
   <source>nothing annotated yet</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>aún no hay nada anotado</translation>
  </message>
  <message>
   <source>{who} on {machine}</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} en {machine}</translation>
  </message>
  <message>
   <source>annotation cannot be read</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>la anotación no se puede leer</translation>
  </message>
  <message>
   <source>Enter runs it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Intro lo ejecuta · ↑ ↓ eligen · Esc cierra</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Panel</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ajuste</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Abrir</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Una acción, elemento, imagen, fuente de cámaras, carpeta o número</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Buscar todo</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Nada se llama «{text}».</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Umbral {px:g} px</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Imagen {number} de {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ir a esta imagen</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juzgar los elementos con este tau</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Lo que encaja</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juzgar {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Juzgar con esta fuente</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ajuste continuo: modelo {model}</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Panel {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Abrir este panel y traerlo al frente</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>activado</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>desactivado</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action guide]</extracomment>
   <translation>Guía</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Buscar palabras en esta página</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>La guía está en inglés.</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>esta instalación vino sin su guía</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>Acerca de ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Anotar y auditar calibraciones de cámaras deportivas con el protocolo ProCC.</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Títulos</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>no hay cámaras cargadas (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>cargue un segundo conjunto de cámaras para verlos lado a lado (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>cargue un segundo conjunto de cámaras para comparar (Ctrl+L)</translation>
  </message>
  <message>
   <source>Brightness</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Brillo</translation>
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
   <translation>Resaltar líneas gastadas y en sombra</translation>
  </message>
  <message>
   <source>Only what you see changes, never the file</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Solo cambia lo que usted ve, nunca el archivo</translation>
  </message>
  <message>
   <source>Reset</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Restablecer</translation>
  </message>
  <message>
   <source>Shift all values</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Desplazar todos los valores</translation>
  </message>
  <message>
   <source>Stretch values about middle grey</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Estirar los valores en torno al gris medio</translation>
  </message>
  <message>
   <source>To the right, dark parts become lighter</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Hacia la derecha, las partes oscuras se aclaran</translation>
  </message>
  <message>
   <source>Line enhance</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Realce de líneas</translation>
  </message>
  <message>
   <source>Show the picture as it is</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Mostrar la imagen tal como es</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Teclas propias</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Teclas (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}: {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Búsqueda: una palabra o una tecla. Un clic hace lo que dice la fila.</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>En la imagen</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Ninguna tecla, acción ni elemento tiene «{text}».</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Búsqueda: una palabra o una tecla</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Elija una fila y pulse sus teclas</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{one} o {other}</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, the action keys]</extracomment>
   <translation>Teclas</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Cambiar teclas</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Solo estas</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Ninguna tecla</translation>
  </message>
  <message>
   <source>Default keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Teclas por defecto</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Importar…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ Las teclas que llaman a dos acciones no llaman a ninguna: dé otras a una de ellas.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Exportar teclas</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Importar teclas</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Teclas nuevas: púlselas aquí</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Buscar en las teclas</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Búsqueda</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Todas las teclas a la vez</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{file}: {error}; las teclas quedan como están</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Acción o elemento</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ también: {what}</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Cambiar la clase a (intercambia con una anotada)</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Dibujando {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Dividir aquí: el resto pasa a ser</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Fantasma de {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Aceptar</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Mirar de cerca</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/menus.py, the action not_visible]</extracomment>
   <translation>No visible aquí</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}: {step}</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Punto {number} de {title}</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>No visible aquí: retirar</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Unir con</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title}, sin confirmar</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>suelo ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>unexpected error ({what}); saving goes on, the details are in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>error inesperado ({what}); se sigue guardando, los detalles están en {path}</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cursor en píxeles de la imagen; el centro del píxel superior izquierdo es 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cursor sobre el suelo del campo, en metros desde su centro</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>A qué distancia ven el cursor la cámara activa y la comparada:
sobre el suelo, y en píxeles del tamaño de evaluación</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Con qué seguridad conoce la cámara ajustada el punto del suelo en el cursor: desviación
típica en la peor dirección, sea cual sea el error del propio cursor</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>puntuando {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cámara &gt; Detener la puntuación del conjunto lo termina</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>comparando {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>fantasmas {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Esc lo termina</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Esta imagen no se puede editar. {problem}</translation>
  </message>
  <message>
   <source>the details are copied; they are in {path}, too</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>los detalles están copiados; también están en {path}</translation>
  </message>
  <message>
   <source>there was no unexpected error; they are logged in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>no hubo ningún error inesperado; se registran en {path}</translation>
  </message>
  <message>
   <source>not editable: the bar over the picture says why</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>no editable: la barra sobre la imagen dice por qué</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Imagen
Brillo, contraste, gamma, realce de líneas: solo cambia lo que usted ve</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Barra de herramientas</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Índice de Jaccard de esta imagen con tau</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Umbral tau: un elemento pasa si todos sus puntos están más cerca (+ y -)</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>El conjunto de cámaras que se juzga (C cambia)</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Estado de esta imagen (panel Revisión)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Con qué se calcula la puntuación: {terms}</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>guardado {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>
    <numerusform>SIN GUARDAR: {n} imagen</numerusform>
    <numerusform>SIN GUARDAR: {n} imágenes</numerusform>
   </translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Campo: {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Clic para elegir otro</translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>guardando...</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Umbral tau</translation>
  </message>
  <message>
   <source>JaC {jac:.3f} of the fit</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>JaC {jac:.3f} (fit)</translation>
  </message>
  <message>
   <source>blind: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>ciego: por entregar</translation>
  </message>
  <message>
   <source>{n} of {total}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>{n} de {total}</translation>
  </message>
  <message>
   <source>The camera is found without a click; dashed: what it expects. Shift+Enter accepts that</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>La cámara se halla sin un clic; a trazos: lo que espera. Mayús+Intro lo acepta</translation>
  </message>
  <message>
   <source>W switches to editing: drag a point off its line</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>W pasa a editar: arrastre un punto fuera de su línea</translation>
  </message>
  <message>
   <source>The tab Check lists possible mistakes: open it. F12 applies the first remedy</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>La pestaña «Comprobación» muestra posibles errores: ábrala. F12 aplica el primer remedio</translation>
  </message>
  <message>
   <source>Ctrl+Enter: this frame is done</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Intro: esta imagen está terminada</translation>
  </message>
  <message>
   <source>Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press Enter, choose its name</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Mayús+D: una imagen sin anotación. W, y dibuje una línea: clic en sus extremos, Intro, elija su nombre</translation>
  </message>
  <message>
   <source>Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your annotation</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>«Juzgar», arriba a la derecha (Mayús+F2), luego C: la cámara ajustada, juzgada con su anotación</translation>
  </message>
  <message>
   <source>File &gt; Export as… writes the annotations for other programs: look at it</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Archivo &gt; Exportar como… escribe las anotaciones para otros programas: véalo</translation>
  </message>
  <message>
   <source>That was the tour. Shift+F1: back to annotating; F1: all keys</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Fin del recorrido. Mayús+F1: volver a anotar; F1: todas las teclas</translation>
  </message>
  <message>
   <source>Go on to the next step</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Pasar al paso siguiente</translation>
  </message>
  <message>
   <source>Esc ends the tour, too</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Esc también termina el recorrido</translation>
  </message>
  <message>
   <source>Skip</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Omitir</translation>
  </message>
  <message>
   <source>End</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Terminar</translation>
  </message>
  <message>
   <source>the sample cannot be copied: {why}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>no se puede copiar el ejemplo: {why}</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Suelte aquí una carpeta de imágenes</translation>
  </message>
  <message>
   <source>Annotations are read from and saved as JSON next to the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Las anotaciones se leen y guardan como JSON junto a las imágenes. Suelte más tarde una carpeta de cámaras para verlas juzgadas con sus clics.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Abrir reciente</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Abrir carpeta…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Abrir imagen…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Abrir vídeo…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Probar el ejemplo</translation>
  </message>
  <message>
   <source>Tour (60 seconds)</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action tour]</extracomment>
   <translation>Recorrido (60 segundos)</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Continuar con</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Aún no se ha abierto nada</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>{setting}: volver a {value}</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Ningún ajuste tiene «{text}».</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Ajustes</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Buscar en los ajustes</translation>
  </message>
  <message>
   <source>Reset all</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Restablecer todo</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>ninguno propio</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py, the action keymap]</extracomment>
   <translation>Cambiar teclas…</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Puntuación</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Ajuste</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Comprobación</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py, the action plots]</extracomment>
   <translation>Gráficos</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Revisión</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Concordancia</translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Anotar</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Juzgar</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Revisar</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[procc_annotator/interaction/camera_view.py, the action disagreement]</extracomment>
   <translation>Desacuerdo</translation>
  </message>
  <message>
   <source>Uncertainty</source>
   <extracomment>[procc_annotator/interaction/camera_view.py]</extracomment>
   <translation>Incertidumbre</translation>
  </message>
  <message numerus="yes">
   <source>{n} to go</source>
   <extracomment>{n} to go / {n} to go [procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>
    <numerusform>falta {n}</numerusform>
    <numerusform>faltan {n}</numerusform>
   </translation>
  </message>
  <message>
   <source>choose an element first: field map, list, or its key</source>
   <extracomment>[procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>elija primero un elemento: mapa del campo, lista o su tecla</translation>
  </message>
  <message>
   <source>{title} is pinned, so that a slip does not move it: drag its points, or unpin elements (Ctrl+P, menu Element) to drag it as a whole</source>
   <extracomment>[procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>{title} está fijado para que un descuido no lo mueva: arrastre sus puntos, o suelte los elementos (Ctrl+P, menú Elemento) para arrastrarlo entero</translation>
  </message>
  <message numerus="yes">
   <source>move {n} points</source>
   <extracomment>move {n} point / move {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>mover {n} punto</numerusform>
    <numerusform>mover {n} puntos</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>delete {n} points</source>
   <extracomment>delete {n} point / delete {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>borrar {n} punto</numerusform>
    <numerusform>borrar {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>draw {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>dibujar {title}</translation>
  </message>
  <message>
   <source>continue {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>continuar {title}</translation>
  </message>
  <message>
   <source>confirm {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>confirmar {title}</translation>
  </message>
  <message>
   <source>move {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>mover {title}</translation>
  </message>
  <message>
   <source>move all of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>mover {title} entero</translation>
  </message>
  <message>
   <source>nudge {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>desplazar {title}</translation>
  </message>
  <message>
   <source>insert a point in {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>insertar un punto en {title}</translation>
  </message>
  <message>
   <source>delete {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>borrar {title}</translation>
  </message>
  <message>
   <source>delete point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>borrar el punto {number} de {title}</translation>
  </message>
  <message numerus="yes">
   <source>nudge {n} points</source>
   <extracomment>nudge {n} point / nudge {n} points [procc_annotator/interaction/gestures.py]</extracomment>
   <translation>
    <numerusform>desplazar {n} punto</numerusform>
    <numerusform>desplazar {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>click to draw; choose its class afterwards</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>clic para dibujar; la clase se elige después</translation>
  </message>
  <message>
   <source>Backspace removes the last point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Retroceso quita el último punto</translation>
  </message>
  <message>
   <source>click marks it and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo marca y pasa a {title}</translation>
  </message>
  <message>
   <source>release drops it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>al soltar queda aquí</translation>
  </message>
  <message>
   <source>click or drag a point, drag elsewhere to select several</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>clic o arrastre en un punto; arrastre en otra parte para elegir varios</translation>
  </message>
  <message>
   <source>arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>las flechas mueven {step:g} px, con Mayús {fine:g} px, Ctrl {far:g} px</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here, or open one with Ctrl+O</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Suelte aquí una carpeta de imágenes, o ábrala con Ctrl+O</translation>
  </message>
  <message>
   <source>Ctrl+Enter commits the frame and shows the projection</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ctrl+Intro entrega la imagen y muestra la proyección</translation>
  </message>
  <message>
   <source>GHOST {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>FANTASMA {title}</translation>
  </message>
  <message>
   <source>GHOST the next one comes in a moment</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>FANTASMA el siguiente llega en un momento</translation>
  </message>
  <message numerus="yes">
   <source>Tab: next of {n} ghosts</source>
   <extracomment>Tab: next of {n} ghost / Tab: next of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab: siguiente de {n} fantasma</numerusform>
    <numerusform>Tab: siguiente de {n} fantasmas</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Tab: first of {n} ghosts</source>
   <extracomment>Tab: first of {n} ghost / Tab: first of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab: primero de {n} fantasma</numerusform>
    <numerusform>Tab: primero de {n} fantasmas</numerusform>
   </translation>
  </message>
  <message>
   <source>Shift+Enter: accept all</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Mayús+Intro: aceptar todos</translation>
  </message>
  <message>
   <source>Enter accepts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro lo acepta</translation>
  </message>
  <message>
   <source>Tab goes on</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Tab sigue</translation>
  </message>
  <message>
   <source>. not visible here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>. no visible aquí</translation>
  </message>
  <message>
   <source>Esc goes back</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc vuelve</translation>
  </message>
  <message>
   <source>/ finds an element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>/ busca un elemento</translation>
  </message>
  <message>
   <source>DRAW</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DIBUJAR</translation>
  </message>
  <message>
   <source>choose an element: field map, list, its key or /</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>elija un elemento: mapa del campo, lista, su tecla o /</translation>
  </message>
  <message numerus="yes">
   <source>DRAW a line, {n} points</source>
   <extracomment>DRAW a line, {n} point / DRAW a line, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>DIBUJAR una línea, {n} punto</numerusform>
    <numerusform>DIBUJAR una línea, {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes, then choose the class</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro o doble clic termina; luego elija la clase</translation>
  </message>
  <message numerus="yes">
   <source>DRAW {title}, {n} points</source>
   <extracomment>DRAW {title}, {n} point / DRAW {title}, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>DIBUJAR {title}, {n} punto</numerusform>
    <numerusform>DIBUJAR {title}, {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro o doble clic termina</translation>
  </message>
  <message>
   <source>click adds the second point and finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic pone el segundo punto y termina</translation>
  </message>
  <message>
   <source>click adds a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic pone un punto</translation>
  </message>
  <message>
   <source>DRAW {title}, unconfirmed</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DIBUJAR {title}, sin confirmar</translation>
  </message>
  <message>
   <source>DRAW {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>DIBUJAR {title}</translation>
  </message>
  <message>
   <source>Enter confirms it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro lo confirma</translation>
  </message>
  <message>
   <source>choose it again, then clicks continue it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>elíjalo de nuevo y los clics lo continúan</translation>
  </message>
  <message numerus="yes">
   <source>click continues it after its {n} points</source>
   <extracomment>click continues it after its {n} point / click continues it after its {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>un clic lo continúa tras su {n} punto</numerusform>
    <numerusform>un clic lo continúa tras sus {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>click starts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo empieza</translation>
  </message>
  <message>
   <source>click moves it here and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo mueve aquí y pasa a {title}</translation>
  </message>
  <message>
   <source>Enter confirms {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro confirma {title}</translation>
  </message>
  <message numerus="yes">
   <source>Esc deselects {n} points</source>
   <extracomment>Esc deselects the point / Esc deselects {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Esc deselecciona el punto</numerusform>
    <numerusform>Esc deselecciona {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>EDIT</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>EDITAR</translation>
  </message>
  <message>
   <source>release selects all points inside</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>al soltar se eligen todos los puntos de dentro</translation>
  </message>
  <message>
   <source>EDIT point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>EDITAR el punto {number} de {title}</translation>
  </message>
  <message>
   <source>release selects the element, which is pinned</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>al soltar se selecciona el elemento, que está fijado</translation>
  </message>
  <message>
   <source>EDIT the element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>EDITAR el elemento</translation>
  </message>
  <message>
   <source>drag moves point {number} of {title}, Alt+Shift+click removes it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>arrastrar mueve el punto {number} de {title}, Alt+Mayús+clic lo quita</translation>
  </message>
  <message>
   <source>click selects {title}, Alt+click inserts a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic selecciona {title}, Alt+clic inserta un punto</translation>
  </message>
  <message>
   <source>click does nothing: there are no points to edit, draw an element first</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic no hace nada: no hay puntos que editar, dibuje antes un elemento</translation>
  </message>
  <message>
   <source>click a point to drag it, elsewhere to deselect</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>clic en un punto para arrastrarlo, en otra parte para deseleccionar</translation>
  </message>
  <message numerus="yes">
   <source>Delete removes {n} points</source>
   <extracomment>Delete removes the point / Delete removes {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Supr quita el punto</numerusform>
    <numerusform>Supr quita {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>click draws it by hand</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo dibuja a mano</translation>
  </message>
  <message numerus="yes">
   <source>Enter accepts {n} points</source>
   <extracomment>Enter accepts {n} point / Enter accepts {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Intro acepta {n} punto</numerusform>
    <numerusform>Intro acepta {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>no line found along it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>no se halla ninguna línea en él</translation>
  </message>
  <message>
   <source>an element's key names it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>la tecla de un elemento la nombra</translation>
  </message>
  <message>
   <source>Enter or double-click finishes and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Intro o doble clic termina y pasa a {title}</translation>
  </message>
  <message>
   <source>Esc cancels</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc cancela</translation>
  </message>
  <message>
   <source>Esc deselects</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc deselecciona</translation>
  </message>
  <message>
   <source>click moves it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo mueve aquí</translation>
  </message>
  <message>
   <source>click marks it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>un clic lo marca</translation>
  </message>
  <message>
   <source>hold Ctrl: no snapping</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>mantener Ctrl: sin ajuste</translation>
  </message>
  <message>
   <source>Delete removes {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Supr quita {title}</translation>
  </message>
  <message>
   <source>EDIT choosing points</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>EDITAR eligiendo puntos</translation>
  </message>
  <message numerus="yes">
   <source>EDIT {n} points</source>
   <extracomment>EDIT {n} point / EDIT {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>EDITAR {n} punto</numerusform>
    <numerusform>EDITAR {n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>READ ONLY</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>SOLO LECTURA</translation>
  </message>
  <message>
   <source>BLIND</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>CIEGO</translation>
  </message>
  <message>
   <source>Shift+Enter finishes and stays</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Mayús+Intro termina y se queda</translation>
  </message>
  <message>
   <source>Esc removes the new point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc quita el punto nuevo</translation>
  </message>
  <message>
   <source>Esc lets go</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc suelta</translation>
  </message>
  <message>
   <source>passes</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>pasa</translation>
  </message>
  <message>
   <source>too far</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>demasiado lejos</translation>
  </message>
  <message>
   <source>annotated, not projected</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>anotado, no proyectado</translation>
  </message>
  <message>
   <source>projected, not annotated</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>proyectado, no anotado</translation>
  </message>
  <message>
   <source>ghost of an unsure camera</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>fantasma de una cámara insegura</translation>
  </message>
  <message>
   <source>ghost: expected here</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>fantasma: se espera aquí</translation>
  </message>
  <message>
   <source>annotated, in its class's colour</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>anotado, en el color de su clase</translation>
  </message>
  <message>
   <source>to be confirmed</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>por confirmar</translation>
  </message>
  <message>
   <source>projection</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>proyección</translation>
  </message>
  <message>
   <source>second annotator</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>segundo anotador</translation>
  </message>
  <message>
   <source>no distance</source>
   <extracomment>[procc_annotator/interaction/overlay_primitives.py]</extracomment>
   <translation>sin distancia</translation>
  </message>
  <message>
   <source>not annotated</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>sin anotar</translation>
  </message>
  <message>
   <source>missed</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>fallado</translation>
  </message>
  <message>
   <source>{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} concuerda: su punto más lejano, el {number}, está a {px} px; pasa con tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} está demasiado lejos: el punto {number} está a {px} px; pasa con tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{title} (judged as {other}, labels mirrored)</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{title} (juzgado como {other}, clases reflejadas)</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the camera does not show it in the picture.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} se pierde: está anotado, pero la cámara no lo muestra en la imagen.</translation>
  </message>
  <message>
   <source>{element} is not annotated, but the camera shows it: a false positive.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} no está anotado, pero la cámara lo muestra: un falso positivo.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} has no distance, because the projection has coinciding samples there; it passes at no tau.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} está demasiado lejos: el punto {number} no tiene distancia, porque la proyección tiene allí muestras coincidentes; no pasa con ningún tau.</translation>
  </message>
  <message>
   <source>As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what is in the picture alone.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>Tal como sigue más allá de la imagen está a lo sumo a {px} px, pero soccernet mide solo hasta lo que hay en la imagen.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the field has no such element to project.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} se pierde: está anotado, pero el campo no tiene tal elemento que proyectar.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but it leaves the ground, and the camera knows only the ground.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} se pierde: está anotado, pero sale del suelo, y la cámara solo conoce el suelo.</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Anotar todas las imágenes de una carpeta</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Anotar una sola imagen</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Anotar imágenes de un vídeo sin extraerlas antes</translation>
  </message>
  <message>
   <source>Season…</source>
   <extracomment>[the action season]</extracomment>
   <translation>Temporada…</translation>
  </message>
  <message>
   <source>List the matches of a season (a folder in which videos lie) to open one of them</source>
   <extracomment>[the action season]</extracomment>
   <translation>Listar los partidos de una temporada (una carpeta con vídeos) para abrir uno de ellos</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Abrir el ejemplo</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Abrir su propia copia de las imágenes que trae el programa</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Abrir segundo anotador…</translation>
  </message>
  <message>
   <source>Draw and compare what another annotator clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Dibujar y comparar lo que otra persona marcó en las mismas imágenes</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Cerrar segundo anotador</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Mostrar de nuevo solo las anotaciones de este conjunto</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Desde un archivo…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Una descripción propia: cualquier deporte, véase la guía</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Cambiar al campo que encaja</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Mostrar el campo que conoce las clases anotadas en esta imagen</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Leer el archivo otra vez</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Ocurre por sí solo cuando se escribe el archivo del campo de este conjunto</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Guardar ahora</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Cada cambio terminado se guarda al momento; esto vuelve a intentar lo que falló</translation>
  </message>
  <message>
   <source>Write what could not be saved in its own place to another folder</source>
   <extracomment>[the action save_copies]</extracomment>
   <translation>Escribir en otra carpeta lo que no se pudo guardar en su lugar</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Importar anotaciones…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Tomar, imagen por imagen, las anotaciones de otro programa o conjunto</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exportar como…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Escribir las anotaciones para otro programa: CVAT, labelme, COCO, SoccerNet, máscaras</translation>
  </message>
  <message>
   <source>Export annotations as JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Exportar anotaciones como JSON…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of JSON files</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Escribir las anotaciones de todas las imágenes como carpeta o zip de archivos JSON</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Exportar el JaC del conjunto…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Escribir el JaC de cada imagen como CSV o JSON</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Exportar procedencia…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Escribir en un JSON adjunto cómo surgió cada punto y por obra de quién</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Guardar imagen superpuesta…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Escribir la imagen con anotación, proyección y leyenda como PNG, JPEG o SVG</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Exportar resumen…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Escribir el estado, los recuentos y el tiempo de cada imagen como CSV</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Exportar veredictos…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Escribir como CSV de quién es el fallo en cada imagen, con el JaC y el mayor error</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Exportar hallazgos…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Escribir como CSV lo que halló la revisión de clases en las imágenes revisadas hasta ahora</translation>
  </message>
  <message>
   <source>Author name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Nombre del autor…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>El nombre que llevan sus puntos, comentarios y versiones</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Salir</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Cerrar la ventana; todo está guardado</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Deshacer</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Retirar el último paso de esta imagen</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Rehacer</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Hacer el paso otra vez</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Borrar punto o elemento</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Quitar el punto seleccionado; si no hay, el elemento seleccionado</translation>
  </message>
  <message>
   <source>Insert point</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Insertar punto</translation>
  </message>
  <message>
   <source>Put a point on the line at the crosshair, or at the mouse (Alt and a click do it, too)</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Poner un punto en la línea bajo la retícula o bajo el ratón (también con Alt y un clic)</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Elegir todos los puntos</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Elegir todos los puntos del elemento seleccionado, o de la imagen</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Descartar los puntos recién marcados y después soltar la selección</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Ajustes…</translation>
  </message>
  <message>
   <source>Theme, text size, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Tema, tamaño de los textos, y cómo dibuja, ajusta y juzga la ventana</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Con las flechas</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Mover 1 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px a la derecha</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px arriba</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px abajo</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Mover 0.1 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px a la derecha</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px arriba</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px abajo</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Mover 10 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px a la derecha</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px arriba</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px abajo</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Mover 100 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px a la derecha</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px arriba</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px abajo</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Imagen siguiente</translation>
  </message>
  <message>
   <source>Show the next picture, of those that the filter shows</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Mostrar la imagen siguiente, de las que muestra el filtro</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Imagen anterior</translation>
  </message>
  <message>
   <source>Show the previous picture, of those that the filter shows</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Mostrar la imagen anterior, de las que muestra el filtro</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Siguiente sin terminar</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Ir a la próxima imagen que no está terminada ni aprobada</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Anterior sin terminar</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Volver a la imagen anterior que no está terminada ni aprobada</translation>
  </message>
  <message>
   <source>Go to</source>
   <extracomment>[the menus]</extracomment>
   <translation>Ir a</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Siguiente rechazada</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Ir a la próxima imagen que devolvió un revisor</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Siguiente peor JaC</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>La imagen con el JaC más bajo; otra vez: la siguiente mejor</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Siguiente mayor error</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>La imagen con el mayor error de un punto; otra vez: la del siguiente menor</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Siguiente por desacuerdo</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>La imagen en que la fuente activa y la comparada más se separan sobre el suelo; otra vez: la siguiente</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Revisión de clases</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Hallazgo siguiente</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Ir a lo siguiente que halló la revisión, de imagen en imagen</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Hallazgo anterior</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Volver al hallazgo anterior</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Aplicar el primer remedio</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Reparar el hallazgo actual: cambiar la clase, intercambiar, quitar el punto malo, o mirarlo</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Siguiente sin anotación</translation>
  </message>
  <message>
   <source>Go to the next frame without annotations</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Ir a la próxima imagen en que no hay nada anotado</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Anterior sin anotación</translation>
  </message>
  <message>
   <source>Go to the previous frame without annotations</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Volver a la imagen anterior en que no hay nada anotado</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Primera imagen</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Mostrar la primera imagen</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Última imagen</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Mostrar la última imagen</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Plano</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Seguir el plano</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Hallar las cámaras de todas las imágenes de este plano, desde esta en ambos sentidos; otra vez lo detiene</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Aceptar el tramo</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; annotated ones are left out, and doubtful ones unless it is pressed again</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Anota las imágenes del plano, o del tramo marcado en la tira, según su seguimiento; se omiten las anotadas, y las dudosas salvo que se pulse otra vez</translation>
  </message>
  <message>
   <source>Annotate all that is sure</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Anotar todo lo seguro</translation>
  </message>
  <message>
   <source>Annotate every frame of the dataset whose camera is found and sure, in one step; Next doubtful frame (Alt+PgDown) then goes through the others, the least sure first</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Anotar en un paso todas las imágenes del conjunto cuya cámara se halló y es segura; «Siguiente imagen dudosa» (Alt+Av Pág) recorre luego las demás, las menos seguras primero</translation>
  </message>
  <message>
   <source>Take back what was accepted last</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Retirar lo último aceptado</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Las imágenes aceptadas en último lugar y no editadas desde entonces vuelven a ser como eran</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Diez imágenes adelante</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Avanzar diez imágenes</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Diez imágenes atrás</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Retroceder diez imágenes</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Siguiente imagen anotada</translation>
  </message>
  <message>
   <source>Go on to the next frame that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Ir a la próxima imagen anotada</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Anterior imagen anotada</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Volver a la imagen anotada anterior</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Siguiente imagen dudosa</translation>
  </message>
  <message>
   <source>Go to the next frame whose track should be checked</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Ir a la próxima imagen cuyo seguimiento conviene mirar</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Anterior imagen dudosa</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Volver a la imagen dudosa anterior</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Reproducir o pausar</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Mostrar las imágenes una tras otra; otra vez, o cualquier cambio, lo detiene</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Buscar imagen…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Escribir una parte del nombre de la imagen</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Modo ciego</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Ocultar la proyección hasta entregar la imagen, para que la cámara no atraiga los clics</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Fijar el conjunto en modo ciego</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Modo ciego para todos los que anotan este conjunto; levantarlo pide confirmación y queda registrado</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Terminada</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Esta imagen está terminada; en modo ciego eso muestra la proyección</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Un revisor da por buena esta imagen</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Un revisor devuelve esta imagen; diga por qué en un comentario</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>De nuevo en curso</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Al final esta imagen no está terminada</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Comentario…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Escribir en el hilo de esta imagen</translation>
  </message>
  <message>
   <source>Comment on this place…</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Comentar este lugar…</translation>
  </message>
  <message>
   <source>Write a comment on the place at the cursor; a numbered pin marks it in the picture</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Escribir un comentario sobre el lugar del cursor; una chincheta numerada lo marca en la imagen</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Versiones anteriores…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Ver todas las versiones guardadas de esta imagen y recuperar una</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Agrupar vistas…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Decir por sus nombres qué imágenes muestran un mismo instante desde distintas cámaras</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Conservar esta imagen del vídeo</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture next to its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Escribir la imagen del vídeo como archivo junto a su anotación</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Copiar de la imagen anterior</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Tomar elementos de la imagen anotada antes, movidos como se movió la cámara; esperan confirmación</translation>
  </message>
  <message>
   <source>Confirm all unconfirmed elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Confirmar todos los elementos sin confirmar</translation>
  </message>
  <message>
   <source>Copied and unfinished elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Los elementos copiados y sin terminar cuentan y se guardan desde ahora</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Descartar elementos sin confirmar</translation>
  </message>
  <message>
   <source>Remove copied and unfinished elements that were not edited</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Quitar los elementos copiados y sin terminar que no se editaron</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Regularizar todos los elementos</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Volver a muestrear cada elemento de la imagen a lo largo de su línea pintada</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Dibujar</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Los clics añaden puntos al elemento elegido</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Arrastrar, insertar y quitar puntos</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Cambiar entre dibujar y editar</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>De dibujar a editar y vuelta</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Elemento siguiente</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Elegir el elemento siguiente del campo</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Elemento anterior</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Elegir el elemento anterior</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Buscar elemento…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Escribir una parte del nombre del elemento</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Terminar elemento</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Hacer un elemento de los puntos recién marcados (o doble clic en el último)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminar y quedarse</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminar el elemento sin pasar al siguiente</translation>
  </message>
  <message>
   <source>Remove the last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Quitar el último punto</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Quitar el último punto marcado</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Borrar elemento</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Quitar el elemento seleccionado con todos sus puntos</translation>
  </message>
  <message>
   <source>Confirm element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Confirmar elemento</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>El elemento seleccionado cuenta y se guarda desde ahora (al editar: Intro)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Regularizar</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Volver a muestrear el elemento a lo largo de su línea pintada: dos clics hacen un elemento recto, cinco una curva</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Cerrar huecos</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Llevar los extremos del elemento hasta la esquina o el borde de la imagen que no alcanzan</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Invertir</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Dar la vuelta al orden de los puntos del elemento</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Duplicar a la clase simétrica</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Poner una copia con la clase del campo girado, para arrastrarla a su sitio</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Ajustarse a las líneas</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click off it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Los clics cerca de una línea pintada van a su centro (mantener Ctrl para marcar al lado)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Pasar al elemento siguiente</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Tras terminar un elemento, elegir el que más probablemente sigue</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Dos clics terminan un elemento recto</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>El segundo clic en un elemento recto lo termina</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Dibujar primero, nombrar después</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Sin elemento elegido, un clic empieza una línea; una vez terminada, se ofrecen junto al lápiz los elementos más probables</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Fijar elementos</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Solo se pueden arrastrar puntos, no elementos enteros</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Fantasmas</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Fantasma siguiente</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Mirar de cerca el próximo elemento que espera la cámara ajustada</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Fantasma anterior</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Mirar de cerca el anterior</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Aceptar fantasma</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Hacer del fantasma un elemento: puntos sobre su línea pintada, ninguno donde está oculta (Intro)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Aceptar todos los fantasmas</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Aceptar todos los fantasmas cuyas líneas pintadas se ven lo bastante bien (Mayús+Intro mientras no se dibuja nada)</translation>
  </message>
  <message>
   <source>Accept all and go on</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Aceptar todos y seguir</translation>
  </message>
  <message>
   <source>Accept all ghosts of this frame and show the next one: one key a frame</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Aceptar todos los fantasmas de esta imagen y mostrar la siguiente: una tecla por imagen</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Parte visible para aceptar todos…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Cuánto de su línea pintada debe verse para aceptar un fantasma junto con los demás</translation>
  </message>
  <message>
   <source>The ghost or the chosen element cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>El fantasma o el elemento elegido no se ve en esta imagen; otra vez lo retira</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Retirar «no visible aquí»</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>El elemento que se dio en último lugar por no visible en esta imagen quizá se vea</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Mostrar fantasmas</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Dibujar curvas tenues donde la cámara ajustada espera elementos aún no anotados</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Buscar la cámara en la imagen</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Donde aún no hay nada anotado, hallar la cámara sin un clic y mostrar sus elementos como fantasmas; nada se guarda antes de aceptarlo</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Decir qué anotar a continuación</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Marcar en el mapa del campo el elemento que más seguridad daría a la cámara ajustada</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Ajustar a la ventana</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Mostrar toda la imagen</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Tamaño real</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Un píxel de la imagen es un píxel de la pantalla</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Acercar</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Ampliar (la rueda del ratón lo hace en el cursor)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Alejar</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Reducir (la rueda del ratón lo hace en el cursor)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Desplazar</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>El botón izquierdo mueve la imagen (o mantener Espacio, o el botón central); Esc lo termina</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Mantener el zoom entre imágenes</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Quedarse en este lugar al cambiar de imagen</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Ocultar superposiciones</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Mostrar la imagen sola (o mantener X)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Colorear por</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Criterio</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Los colores dicen cómo se juzga la cámara</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Clase</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Cada elemento en su propio color</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Procedencia</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Puntos según cómo surgieron: marcados, ajustados, regularizados, copiados, movidos</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Anotador</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Puntos según quién los puso</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Anchura pintada</translation>
  </message>
  <message>
   <source>Draw how wide the field's lines must appear, along the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Dibujar junto a la proyección qué ancho debe tener la pintura de las líneas del campo</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Indicios de pintura</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Junto a cada tramo una tira: continua donde la imagen muestra pintura debajo, discontinua donde la pintura pasa al lado, en ese lado, punteada donde no hay</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Lupa</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Mantener la lupa en el cursor (o mantener Z; también aparece al arrastrar un punto)</translation>
  </message>
  <message>
   <source>Legend in the picture</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Leyenda en la imagen</translation>
  </message>
  <message>
   <source>What the colours, dashes and marks over the picture mean, in its corner; it gives way to the hand</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Lo que significan los colores, trazos y marcas sobre la imagen, en su esquina; cede el paso a la mano</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Girar el mapa hacia la cámara</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>El mapa tiene abajo el lado en que está la cámara, y lo que esta no ve es tenue</translation>
  </message>
  <message>
   <source>Picture on the field map</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Imagen en el mapa del campo</translation>
  </message>
  <message>
   <source>Show the picture on the field map, as seen from above: lines that bend or miss the map's show where a camera is wrong</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Mostrar la imagen vista desde arriba en el mapa del campo: las líneas que se curvan o no coinciden con las del mapa muestran dónde falla una cámara</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Tira de imágenes</translation>
  </message>
  <message>
   <source>Below the picture: thumbnails of the frames, or the timeline of a video</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bajo la imagen: miniaturas de las imágenes, o la línea de tiempo de un vídeo</translation>
  </message>
  <message>
   <source>List of frames</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Lista de imágenes</translation>
  </message>
  <message>
   <source>Show the frames with their names and a filter at the left, instead of the strip; once more closes the list</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Mostrar a la izquierda las imágenes con sus nombres y un filtro, en lugar de la tira; otra vez cierra la lista</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Errores y JaC de la imagen o del conjunto, de todas las fuentes mostradas</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Paneles para anotar</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Elementos, hallazgos de la revisión, marcas</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Paneles para juzgar</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Puntuaciones, fuentes de cámaras, ajuste, gráficos</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Paneles para revisar</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Estado, comentarios y tiempo, un segundo anotador</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Ocultar todos los paneles</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Dar todo el espacio a la imagen</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Teclado a los paneles</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>En la imagen, Tab recorre los fantasmas; esto lleva el teclado a los paneles</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Teclado a la parte siguiente</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Imagen, paneles, barras: el teclado las recorre</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Teclado a la parte anterior</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>El mismo recorrido al revés</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Restablecer la disposición</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Volver a poner los paneles donde estaban al principio</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Cargar cámaras…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Juzgar una carpeta de cámaras u homografías con las anotaciones</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Cargar archivo de cámara…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Juzgar un solo archivo de cámara, o un zip de ellos</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Siguiente fuente de cámaras</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Juzgar con la siguiente de las fuentes cargadas</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Anterior fuente de cámaras</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Juzgar con la anterior</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Intercambiar con la fuente comparada</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Juzgar con la fuente comparada y comparar con esta (o pulsar la coma; mantenerla solo para mirar)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Dibujar otras fuentes</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes, with the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Dibujar las fuentes marcadas en el panel Cámaras como armazones junto a la activa</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Vista dividida</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Dibujar la fuente activa a la izquierda de un divisor y la comparada a la derecha</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>A cuántos metros ven la fuente activa y la comparada cada píxel sobre el suelo</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Mapa de incertidumbre</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Dónde del campo la cámara ajustada acierta hasta 0.1, 0.5 y 1 m</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajuste continuo</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajustar una cámara a los clics de la imagen tras cada cambio</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Guardar el ajuste como cámara de la imagen</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Escribir la cámara ajustada a los clics en la carpeta cameras/fitted del conjunto</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Dimensiones del campo…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Longitud y anchura del campo de este estadio, introducidas o halladas con todas las imágenes; y en qué parte de sus líneas están los clics</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Umbral: 0.5 px más</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Permitir distancias mayores</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Umbral: 0.5 px menos</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Permitir solo distancias menores</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>La evaluación oficial de SoccerNet, con sus rarezas</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>La definición del artículo, sin los artefactos del código oficial</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Elementos fuera del suelo</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Contar como fallados</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Las porterías, canastas y redes que una homografía no puede proyectar cuentan en su contra</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Las porterías, canastas y redes que una homografía no puede proyectar no se cuentan</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Cámara errónea</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>La cámara activa está mal en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Anotación errónea</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Los clics están mal en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>OK</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>La cámara y los clics están bien en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Nota al veredicto…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Decir en pocas palabras qué está mal; se exporta con el veredicto</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Detener la puntuación del conjunto</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Dejar de calcular el JaC de las imágenes aún no abiertas y de comparar fuentes</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Buscar lo que sea…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>La paleta de órdenes: toda acción, elemento, imagen, fuente de cámaras y carpeta reciente, con unas letras de su nombre</translation>
  </message>
  <message>
   <source>Draw, accept, check, judge and export, step by step, on a copy of the sample</source>
   <extracomment>[the action tour]</extracomment>
   <translation>Dibujar, aceptar, revisar, juzgar y exportar, paso a paso, en una copia del ejemplo</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Mostrar todas las acciones y sus teclas en una hoja</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Dar otras teclas a acciones y elementos, o tomar las de otro programa</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>La guía que trae el programa; no necesita red</translation>
  </message>
  <message>
   <source>Copy details of the last error</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Copiar detalles del último error</translation>
  </message>
  <message>
   <source>What an unexpected error left in the log, for a report to the maintainers</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Lo que un error inesperado dejó en el registro, para informar a los responsables</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Versión</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Aspecto</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Tema</translation>
  </message>
  <message>
   <source>Light, dark or system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Claro, oscuro o como el sistema</translation>
  </message>
  <message>
   <source>System</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Sistema</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Claro</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Oscuro</translation>
  </message>
  <message>
   <source>Text size</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Tamaño del texto</translation>
  </message>
  <message>
   <source>Text size, % of system (after restart)</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Tamaño del texto, % del sistema (tras reiniciar)</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Idioma</translation>
  </message>
  <message>
   <source>Language of the window (after restart); files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Idioma de la ventana (tras reiniciar); los archivos quedan como están</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Lo que dicen los colores sobre la imagen</translation>
  </message>
  <message>
   <source>Author name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Nombre del autor</translation>
  </message>
  <message>
   <source>Author name (empty = login name)</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Nombre del autor (vacío = nombre de usuario)</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Evaluación</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Umbral</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>A qué distancia de su elemento puede estar un punto anotado, en px del tamaño de evaluación</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Cómo se juzgan las cámaras: como la evaluación oficial, con sus rarezas, o según la definición del artículo</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (artículo)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Cómo cuentan los elementos que una homografía no puede proyectar: porterías, canastas, redes</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modelo del ajuste continuo</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>La cámara que se ajusta a los clics; auto: la más sencilla que permiten</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Juzgar el ajuste</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Si se juzga el ajuste donde no hay otra cosa</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Parte visible para aceptar todos</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Cuánto de la línea de un fantasma debe verse para aceptarlo con todos los demás</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Fútbol americano (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea lateral cercana</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea lateral lejana</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marcas hash cercanas</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marcas hash lejanas</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Línea de meta izquierda</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 5 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 10 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 15 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 20 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 25 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 30 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 35 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 40 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 45 yardas izquierda</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 50 yardas</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Línea de meta derecha</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 5 yardas derecha</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 10 yardas derecha</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 15 yardas derecha</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 20 yardas derecha</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 25 yardas derecha</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 30 yardas derecha</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 35 yardas derecha</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 40 yardas derecha</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 45 yardas derecha</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Travesaño izquierdo</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería izquierda, poste izquierdo</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería izquierda, poste derecho</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Travesaño derecho</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería derecha, poste izquierdo</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería derecha, poste derecho</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marca de conversión izquierda</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marca de conversión derecha</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longitud con ambas zonas de anotación</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Profundidad de una zona de anotación</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yarda</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De la línea de yarda a la lateral</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De las marcas hash a la lateral</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De la marca de conversión a la línea de gol</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longitud de la marca de conversión</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Anchura de la portería</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Altura del travesaño</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Postes sobre el travesaño</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Anchura de las líneas</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Anchura de la línea de gol</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Anchura del borde</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Mitad izquierda</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Mitad derecha</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Portería derecha</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Atletismo (pista de 400 m)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordillo</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calle 8, borde exterior</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calle 9, borde exterior</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de meta</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 110 m vallas</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 3000 m y 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle libre</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta, línea interior</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Longitud con ocho calles</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Anchura con ocho calles</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Anchura de calle</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calles</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Meta y salidas</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Baloncesto (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea central</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Círculo central</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea de tiros libres izquierda</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de tiros libres izquierdo</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha, lado lejano</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea de tiros libres derecha</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de tiros libres derecho</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arco de tres puntos izquierdo</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos izquierda, recta lejana</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos izquierda, recta cercana</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arco de tres puntos derecho</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos derecha, recta lejana</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos derecha, recta cercana</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tablero izquierdo</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Aro izquierdo</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de no carga izquierdo</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tablero derecho</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Aro derecho</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de no carga derecho</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectángulo del tablero izquierdo</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centro del aro izquierdo</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectángulo del tablero derecho</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centro del aro derecho</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Longitud</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Línea central más allá de las laterales</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Radio del círculo</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Longitud de la zona</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura de la zona</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radio de tres puntos</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>De la línea de tres puntos a la lateral</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Radio de no carga</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Del tablero a la línea de fondo</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura del tablero</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del tablero</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Borde inferior del tablero</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura del rectángulo del tablero</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del rectángulo del tablero</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del aro</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radio del aro</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Del aro al tablero</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Pista</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de tres puntos izquierda</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de tres puntos derecha</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Canasta izquierda</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Canasta derecha</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Baloncesto (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo de tiros libres izquierdo</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo de tiros libres derecho</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arco de zona restringida izquierdo</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arco de zona restringida derecho</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo central interior</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash lejana izquierda</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash lejana derecha</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash cercana izquierda</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash cercana derecha</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radio del círculo interior</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radio de la zona restringida</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>De la marca hash a la línea de fondo</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Longitud de la marca hash</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Fútbol sala</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de banda cercana</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de banda lejana</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de medio campo</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Línea del área izquierda</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Línea del área derecha</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda, poste lejano</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda, poste cercano</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería derecha, poste lejano</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería derecha, poste cercano</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto central</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto de penalti izquierdo</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Segundo punto de penalti izquierdo</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto de penalti derecho</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Segundo punto de penalti derecho</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina lejano izquierdo</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina cercano izquierdo</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina lejano derecho</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina cercano derecho</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, izquierda exterior</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, izquierda interior</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, derecha interior</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, derecha exterior</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, izquierda exterior</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, izquierda interior</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, derecha interior</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, derecha exterior</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Anchura de los postes</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radio del área de penalti</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Del punto de penalti a la línea de meta</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Del segundo punto de penalti a la línea de meta</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radio del círculo central</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Radio de los arcos de esquina</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Altura de la portería</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Terreno</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Área grande izquierda</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Área grande derecha</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Marcas</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Esquinas</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zonas de sustitución</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Balonmano</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Línea lateral cercana</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Línea lateral lejana</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Zona de saque inicial</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea del área de portería izquierda</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 7 metros izquierda</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 4 metros izquierda</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea del área de portería derecha</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 7 metros derecha</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 4 metros derecha</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio lejana, izquierda</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio lejana, derecha</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio cercana, izquierda</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio cercana, derecha</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radio del área de portería</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radio de la línea de golpe franco</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Área de portería izquierda</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Área de portería derecha</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Líneas de cambio</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Hockey sobre hielo (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla lateral cercana</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla lateral lejana</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla de fondo izquierda</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla de fondo derecha</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina cercana izquierda</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina lejana izquierda</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina cercana derecha</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina lejana derecha</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Línea azul izquierda</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Línea azul derecha</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo cercano derecho</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo lejano derecho</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Área de portería izquierda</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería izquierda, poste izquierdo</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería izquierda, poste derecho</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Área de portería derecha</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería derecha, poste izquierdo</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería derecha, poste derecho</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio izquierdo, cercano</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio izquierdo, lejano</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio derecho, cercano</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio derecho, lejano</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zona del árbitro, cercana</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zona del árbitro, lejana</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto central</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona cercano derecho</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona lejano derecho</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral cercano derecho</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral lejano derecho</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla cercana</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla lejana</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla izquierda</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla derecha</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina cercana izquierda</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina lejana izquierda</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina cercana derecha</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina lejana derecha</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de las esquinas</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Altura de la valla</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>De la línea de gol a la valla de fondo</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>De la línea azul a la valla de fondo</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de los círculos de saque</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto de zona a la línea de gol</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto neutral a la línea azul</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto al eje longitudinal</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio del área de portería</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Anchura del área de portería</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de la zona del árbitro</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio en la línea de gol</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio en la valla de fondo</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Anchura de las líneas azules y central</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Vallas</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Líneas</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculos de saque</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Puntos de saque</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de las vallas</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Hockey sobre hielo (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>De la línea azul a la línea de gol</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Fútbol</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, frente</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, frente</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, lado lejano</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Semicírculo del área izquierda</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Semicírculo del área derecha</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería izquierda, frente</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería derecha, frente</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área de portería derecha, lado lejano</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín lejano izquierdo (pie)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín cercano izquierdo (pie)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín lejano derecho (pie)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín cercano derecho (pie)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profundidad del área grande</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Anchura del área grande</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profundidad del área pequeña</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Anchura del área pequeña</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Portería desconocida</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Línea desconocida</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tenis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de dobles lejana</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de dobles cercana</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de individuales lejana</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de individuales cercana</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de servicio izquierda</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de servicio derecha</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea central de servicio</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Borde superior de la red</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poste de red lejano</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poste de red cercano</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Faja central de la red</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Palo de individuales lejano</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Palo de individuales cercano</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marca central izquierda</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marca central derecha</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de individuales</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>De la línea de servicio a la red</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de la línea de fondo</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de la línea central</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Longitud de la marca central</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en la faja</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en los postes</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en los palos de individuales</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Del poste de red a la lateral</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Cuadros de servicio</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Red</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Voleibol</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Línea de ataque izquierda</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Línea de ataque derecha</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Banda superior de la red</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Banda inferior de la red</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena lejana</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena cercana</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poste lejano</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poste cercano</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación lejana izquierda</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación cercana izquierda</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación lejana derecha</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación cercana derecha</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque lejana izquierda</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque cercana izquierda</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque lejana derecha</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque cercana derecha</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>De la línea de ataque a la central</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Altura de la red</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ancho de la malla</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longitud de la red</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena sobre la red</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Del poste a la lateral</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Altura de los postes</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación de la línea de ataque</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>De la marca de saque a la línea de fondo</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longitud de la marca de saque</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marcas fuera de la pista</translation>
  </message>
 </context>
</TS>
