(()=>{var nn=class extends Error{constructor(e,t,n){super(`${t?t+": ":""}${n} [${e}]`),this.code=e,this.where=t}};function w(r,e,t){throw new nn(r,e,t)}var G=class extends Error{};var ai=65536,ci=16384,dc=2**30,Tt=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size}expect(){}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},Un=class r{static async open(e,t=()=>{},n,s=rn(e)){let i=new r;Object.assign(i,{url:e,progress:t,signal:n,name:s,fetched:0,begun:0,expected:null});let o=await i._ask({Range:`bytes=0-${ai-1}`}),c=/\/(\d+)$/.exec(o.headers.get("Content-Range")??"");i.ranged=o.status===206&&c!==null,o.status===206&&!i.ranged&&(await o.body?.cancel(),o=await i._ask({}));let l=Number(o.headers.get("Content-Length"))||0;i.ranged||(i.expected=l);let f=i.ranged?ai:dc;return l>f&&await i._tooLong(o,f),i.head=await i._collect(o,f),i.size=i.ranged?Number(c[1]):i.head.length,i}async read(e,t){if(!this.ranged||t<=this.head.length)return this.head.subarray(e,Math.min(t,this.size));let n=Math.max(0,this.size-ci);return e<n?this._range(e,t):(this.tail??=this._range(n,this.size),(await this.tail).subarray(e-n,t-n))}expect(e){if(!this.ranged)return;let t=([s,i])=>i<=this.head.length||s>=this.size-ci,n=e.filter(s=>!t(s)).reduce((s,[i,o])=>s+o-i,0);Object.assign(this,{begun:this.fetched,expected:n})}async _range(e,t){let n=await this._ask({Range:`bytes=${e}-${t-1}`});if(n.status!==206)throw new G(`${this.name}: the server forgot about ranges`);let s=await this._collect(n,t-e);if(s.length<t-e)throw new G(`${this.name}: the server sent ${s.length} bytes of ${t-e}`);return s}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let s=new URL(this.url,location.href).protocol==="file:";throw new G(s?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new G(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let n=[],s=0,i=e.body.getReader();for(;;){let{done:l,value:f}=await i.read();if(l)break;s+=f.length,s>t&&await this._tooLong(i,t),n.push(f),this.fetched+=f.length,this.progress(this.fetched-this.begun,this.expected)}let o=new Uint8Array(s),c=0;for(let l of n)o.set(l,c),c+=l.length;return o}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new G(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function rn(r){let e=new URL(r,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||r}catch{return e}}var Dn=class{constructor(e){Object.assign(this,{place:e,lines:new Map})}say(e,t=!1,n="page"){e?this.lines.set(n,{text:e,calm:t}):this.lines.delete(n);let s=[...this.lines.values()],i=new Set(s.map(o=>o.text));this.place.hidden=!s.length,this.place.replaceChildren(...[...i].map(o=>Object.assign(document.createElement("span"),{textContent:o}))),this.place.classList.toggle("calm",s.every(o=>o.calm))}},$e=(r,e,t)=>Math.min(Math.max(r,e),t),Hn=r=>((r+180)%360+360)%360-180;function dt(r){return r<1e6?`${Math.round(r/1e3)} kB`:`${(r/1e6).toFixed(r<1e7?2:1)} MB`}var li={azimuth:.6,elevation:.35,fov:30},Bn=89*Math.PI/180,gc=.95,_c=Array.from({length:16},(r,e)=>e*Math.PI/8),$n={azimuth:null,elevation:null,distance:null,share:null},vc={low:$n,high:$n,lowFov:null,highFov:null},Ge=(r,e,t=1)=>r.map((n,s)=>n+t*e[s]),sn=(r,e)=>r.map(t=>t*e),Ur=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),yc=r=>sn(r,1/Math.hypot(...r)),ui=([r,e,t],[n,s,i])=>[e*i-t*s,t*n-r*i,r*s-e*n],fi=r=>$e(r,-Bn,Bn),Dr=({minCameraOrbit:r,maxCameraOrbit:e,minFieldOfView:t,maxFieldOfView:n})=>({low:r??$n,high:e??$n,lowFov:t,highFov:n});function hi(r,e,t){let n=Ge(r,e,-1),s=Math.hypot(...n);return{azimuth:Math.atan2(n[0],n[2]),elevation:Math.asin(n[1]/s),distance:s,target:e,fov:t}}var Gn=class{constructor(){Object.assign(this,{target:[0,0,0],distance:1,framed:1,size:1,turntable:0,...li}),this.limits=vc}place(e,t,n){let s=e.map(v=>Object.fromEntries(Object.entries(v).filter(([,x])=>x!=null))),{azimuth:i,elevation:o,fov:c,target:l=[],distance:f,share:h=1}=Object.assign({},li,...s),{lowFov:m,highFov:_}=this.limits;Object.assign(this,{azimuth:i,elevation:o,fov:$e(c,m??0,_??1/0)}),t&&this.frame(t,n),this.framed=this.distance,this.distance=f??h*this.framed,this.target=this.target.map((v,x)=>l[x]??v),this.limit()}limit(){let{low:e,high:t,lowFov:n,highFov:s}=this.limits,i=({distance:o,share:c})=>o??(c===null?null:c*this.framed);this.azimuth=$e(this.azimuth,e.azimuth??-1/0,t.azimuth??1/0),this.elevation=$e(this.elevation,t.elevation??-Bn,e.elevation??Bn),this.distance=$e(this.distance,i(e)??.001*this.size,i(t)??1e4*this.size),this.fov=$e(this.fov,n??0,s??1/0)}frame({min:e,max:t},n){this.target=sn(Ge(e,t),.5),this.size=Math.hypot(...Ge(t,e,-1))/2||1;let s=gc*Math.tan(this.fov*Math.PI/360),i=Array.from({length:8},(c,l)=>Ge([0,1,2].map(f=>(l>>f&1?t:e)[f]),this.target,-1)),o=_c.flatMap(c=>{let{forward:l,side:f,above:h}=this._axes(c);return i.map(m=>Math.max(Math.abs(Ur(m,h)),Math.abs(Ur(m,f))/n)/s-Ur(m,l))});this.distance=Math.max(...o)||this.size}get position(){return Ge(this.target,this._away(this.turntable),this.distance)}turn(e,t){this.azimuth+=e,this.elevation+=t,this.limit()}zoom(e){this.distance*=e,this.limit()}pan(e,t){let{side:n,above:s}=this._axes(),i=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=Ge(Ge(this.target,n,e*i),s,t*i)}camera(e,t){let{forward:n,side:s,above:i}=this._axes(),o=Math.tan(this.fov*Math.PI/360),c=o*e/t;return{position:this.position,corner:Ge(Ge(n,s,-c),i,o),stepX:sn(s,2*c/e),stepY:sn(i,-2*o/t)}}_away(e){let t=Math.cos(this.elevation),n=this.azimuth+e;return[t*Math.sin(n),Math.sin(this.elevation),t*Math.cos(n)]}_axes(e=this.turntable){let t=sn(this._away(e),-1),n=yc(ui(t,[0,1,0]));return{forward:t,side:n,above:ui(n,t)}}};var qe=Math.PI/180,wc={deg:qe,rad:1},xc={m:1,cm:.01,mm:.001},bc={"%":.01};function jn(r,e){throw new Error(`expected ${r}, found ${JSON.stringify(e)}`)}function $r(r,e){let[,t,n]=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(r)??[];return Object.hasOwn(e,n??"")?Number(t)*e[n]:null}function on(r,e,t){let n=r.trim().split(/\s+/);return n.length!==t.length&&jn(e,r),n.map((s,i)=>s==="auto"?null:t[i](s)??jn(e,r))}var Mt=r=>$r(r,wc),qn=r=>$r(r,xc),It=(r,e,t=!1)=>n=>{let s=Number(n);return n.trim()!==""&&s>=r&&s<=e&&(!t||Number.isInteger(s))?s:jn(`a ${t?"whole ":""}number from ${r} to ${e}`,n)},gt=(...r)=>e=>r.includes(e)?e:jn(r.join(" or "),e),Nt=r=>r,Ke=()=>!0;function Hr(r){let e=o=>qn(o)??$r(o,bc),[t,n,s]=on(r,"THETA PHI RADIUS, as 45deg 75deg 2m",[Mt,Mt,e]),i=r.trim().endsWith("%");return{azimuth:t,elevation:n===null?null:fi(Math.PI/2-n),distance:i?null:s,share:i?s:null}}var Gr=r=>on(r,"X Y Z, as 0m 0.5m 0m",[qn,qn,qn]);function Br(r){let[e]=on(r,"an angle, as 30deg",[Mt]);return e===null?null:Math.min(170,Math.max(1,e/qe))}var pi=r=>on(r,"an angle, as 90deg",[Mt])[0]/qe;function Ac(r){if(r.trim()==="none")return{sun:0};let e=i=>i>=0?Number(i):null,[t,n,s]=on(r,"none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2",[Mt,Mt,e]);return{sunAzimuth:(t??40*qe)/qe,sunHeight:(n??45*qe)/qe,sun:s??2}}var an={src:Nt,alt:Nt,poster:Nt,scene:Nt,environment:Nt,tier:Nt,loading:gt("auto","lazy","eager"),reveal:gt("auto","manual"),"camera-orbit":Hr,"camera-target":Gr,"field-of-view":Br,"min-camera-orbit":Hr,"max-camera-orbit":Hr,"min-field-of-view":Br,"max-field-of-view":Br,sun:Ac,"light-rotation":pi,"environment-intensity":It(0,1e6),ground:Ke,exposure:It(-30,30),"view-transform":gt("srgb","filmic"),"camera-controls":Ke,"disable-zoom":Ke,"disable-pan":Ke,"disable-light":Ke,"touch-action":gt("pan-y","pan-x","none"),"wheel-zoom":gt("focus","always"),"interaction-prompt":gt("auto","none"),"auto-rotate":Ke,"auto-rotate-delay":It(0,1e9),"rotation-per-second":pi,samples:It(1,1e6,!0),"pixel-ratio":It(.1,8),jitter:It(0,1),"first-look":gt("auto","off")},Yn=r=>r.replace(/-(.)/g,(e,t)=>t.toUpperCase()),Zn=r=>String(Number(r.toPrecision(6))),Ot=r=>`${Zn(r)}deg`,mi=r=>`${Zn(r)}m`;function cn({azimuth:r,elevation:e,distance:t,target:n,fov:s}){let i=r/qe,o=i-360*Math.round(i/360);return{cameraOrbit:`${Ot(o)} ${Ot(90-e/qe)} ${mi(t)}`,cameraTarget:n.map(mi).join(" "),fieldOfView:Ot(s)}}function Wn({rotation:r,strength:e,suns:t,sun:n,sunAzimuth:s,sunHeight:i}){return{sun:t||!(n>0)?"none":`${Ot(s)} ${Ot(i)} ${Zn(n)}`,lightRotation:Ot(r),environmentIntensity:Zn(e)}}function di(r){let e=new OffscreenCanvas(1,1).getContext("2d");e.fillStyle=r,e.fillRect(0,0,1,1);let[t,n,s,i]=[...e.getImageData(0,0,1,1).data].map(o=>o/255);return i<1?null:[t,n,s].map(o=>o<=.04045?o/12.92:((o+.055)/1.055)**2.4)}var qr={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,RNA_NOTHING:4294967295,RNA_IS_SEGMENT:1,RNA_SURFACE_SHIFT:1,RNA_HAS_BEFORE:1,RNA_HAS_AFTER:2,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,IS_LIGHT:2147483648,MATERIAL_PART:4294967294,CATCHER_PART:4294967293,SUM_GROUPS:5,CAMERA_RAY:1,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,DISK:1,IMAGE:2,POINT:3,RECTANGLE:4,SPHERE:5,SPOT:6,SUN:7,TRIANGLES:8,UNIFORM:9},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},RnaRow:{words:16,members:{position:{at:0,type:"u32",count:3},h:{at:3,type:"u32",count:1},axis:{at:4,type:"u32",count:3},reserved:{at:7,type:"u32",count:1},wo:{at:8,type:"u32",count:3},reserved_2:{at:11,type:"u32",count:1},wi:{at:12,type:"u32",count:3},reserved_3:{at:15,type:"u32",count:1}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaPrimitive:{words:4,members:{a:{at:0,type:"u32",count:1},b:{at:1,type:"u32",count:1},c:{at:2,type:"u32",count:1},tag:{at:3,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},own:{at:31,type:"u32",count:1}}},Frame:{words:40,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},list:{at:28,type:"u32",count:1},next_list:{at:29,type:"u32",count:1},table_size:{at:30,type:"u32",count:1},objects:{at:31,type:"u32",count:1},surfaces:{at:32,type:"u32",count:1},lights:{at:33,type:"u32",count:1},albedo:{at:34,type:"u32",count:1},domains:{at:35,type:"u32",count:1},textures:{at:36,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Query:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}},PathQueries:{words:48,members:{at_point:{at:0,record:"Query",count:1},at_light:{at:24,record:"Query",count:1}}},Object:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},step:{at:2,type:"f32",count:1},passes:{at:3,type:"u32",count:1}}},Surface:{words:36,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},textures:{at:20,type:"u32",count:8},through:{at:28,type:"u32",count:1},cutoff:{at:29,type:"f32",count:1},ior:{at:30,type:"f32",count:2},f0:{at:32,type:"f32",count:1}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},disk:{colour:0,frame:3,radius:15},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},point:{colour:0,place:3},rectangle:{colour:0,frame:3,half:15},sphere:{colour:0,centre:3,radius:6},spot:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},sun:{colour:0,axis:3,one_minus_cosine:6},triangles:{colour:0,rotation:3,place:12,scale:15},uniform:{colour:0}},viewerLights:{sun:0,environment:1,given:2,aroundPoint:3,mirror:4}};var{constants:ie,records:ue,viewerLights:jr}=qr;function gi(r){for(let[,e,t]of r.matchAll(/struct (\w+) \{([^}]*)\}/g)){let n={},s=0;for(let[,i,o]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let c=Number(/vec(\d)/.exec(o)?.[1]??1),l=c===3?4:c,f=Math.ceil(s/l)*l;n[i]={at:f,type:o.includes("u32")?"u32":"f32",count:c},s=f+c}ue[e]={words:4*Math.ceil(s/4),members:n}}}function ce(r,e){let t=new Uint32Array(ue[r].words);return yi(t,new Float32Array(t.buffer),0,r,e),t}var _i=Object.entries(jr).map(([r,e])=>`const LIGHT_${r.replace(/[A-Z]/g,"_$&").toUpperCase()}: u32 = ${e}u;`).join(`
`),Je=r=>4*ue[r].words;function vi(r,e){let t=[];for(let[n,s]of Object.entries(e))[s].flat().forEach((i,o)=>{t[qr.lights[r][n]+o]=i});return Float32Array.from(t,n=>n??0)}function yi(r,e,t,n,s){for(let[i,o]of Object.entries(s)){let{at:c,type:l,record:f}=ue[n].members[i],h=t+c,m=typeof o=="number"?[o]:o;f?[m].flat().forEach((_,v)=>yi(r,e,h+v*ue[f].words,f,_)):(l==="f32"?e:r).set(m,h)}}var{RNA_IS_SEGMENT:Rc}=ie,{words:kc,members:Xn}=ue.RnaNode,{words:Sc,members:Wr}=ue.RnaPrimitive,Tc=1,Qe=(r,e)=>r.map((t,n)=>t-e[n]),Vn=(r,e,t)=>r.map((n,s)=>n+t*e[s]),Re=(r,e)=>r[0]*e[0]+r[1]*e[1]+r[2]*e[2],Zr=([r,e,t],[n,s,i])=>[e*i-t*s,t*n-r*i,r*s-e*n],Ic=r=>r.map(e=>e/(Math.hypot(...r)||1));function Kn({nodes:r,primitives:e,points:t},n,s){let i=new Float32Array(r.buffer,r.byteOffset,r.length),o=[Tc],c=null;for(;o.length;){let f=o.pop(),h=kc*f,m=r[h+Xn.child.at],_=r[h+Xn.count.at];if(Nc(i,h,n,s,c?.distance??1/0)){_||o.push(m,f+1);for(let v=0;v<_;v++){let x=e.subarray(Sc*(m+v)),N=(x[Wr.tag.at]&Rc?Mc:Oc)(x,t,n,s);N&&N.distance<(c?.distance??1/0)&&(c=N)}}}if(!c)return null;let l=Re(c.normal,s)>0?-1:1;return{distance:c.distance,position:Vn(n,s,c.distance),normal:Ic(c.normal).map(f=>l*f)}}function Nc(r,e,t,n,s){let i=0,o=s;for(let c=0;c<3;c++){let l=r[e+Xn.low.at+c]-t[c],f=r[e+Xn.high.at+c]-t[c];if(n[c]===0){if(l>0||f<0)return!1;continue}let h=l/n[c],m=f/n[c];i=Math.max(i,Math.min(h,m)),o=Math.min(o,Math.max(h,m))}return i<=o}var Yr=(r,e)=>[r[4*e],r[4*e+1],r[4*e+2]];function Oc(r,e,t,n){let[s,i,o]=["a","b","c"].map(N=>Yr(e,r[Wr[N].at])),c=Qe(i,s),l=Qe(o,s),f=Zr(n,l),h=Re(c,f);if(h===0)return null;let m=Qe(t,s),_=Zr(m,c),v=Re(m,f)/h,x=Re(n,_)/h,A=Re(l,_)/h;return v>=0&&x>=0&&v+x<=1&&A>0?{distance:A,normal:Zr(c,l)}:null}function Mc(r,e,t,n){let s=r[Wr.a.at],i=Yr(e,s),o=Qe(Yr(e,s+1),i),c=Qe(t,i),l=Re(o,o),f=Re(o,n),h=l-f*f,m=h>0?(Re(c,o)-f*Re(c,n))/h:0,_=Math.min(1,Math.max(0,m)),v=Vn(i,o,_),x=Re(Qe(v,t),n),A=Qe(Vn(t,n,x),v),N=e[4*s+3]+_*(e[4*s+7]-e[4*s+3]),D=N*N-Re(A,A);if(D<0)return null;let q=x-Math.sqrt(D);return q>0?{distance:q,normal:Qe(Vn(t,n,q),v)}:null}var Lc=.002,Pc={childList:!0,subtree:!0,attributes:!0,attributeFilter:["slot","data-position","data-normal"]},xi=(r,e)=>r.map((t,n)=>t-e[n]),Vr=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),bi=r=>r.map(e=>e/Math.hypot(...r));function Ai({corner:r,stepX:e,stepY:t,width:n,height:s},i,o){return bi(r.map((c,l)=>c+i*n*e[l]+o*s*t[l]))}function Fc({position:r,corner:e,stepX:t,stepY:n,width:s,height:i},o){let c=t.map(v=>v*s),l=n.map(v=>v*i),f=xi(o,r),h=(v,x)=>Vr(x,v)/Vr(v,v),m=e.map((v,x)=>v+.5*(c[x]+l[x])),_=h(m,f);return _>0?[.5+h(c,f)/_,.5+h(l,f)/_]:null}var Jn=class{constructor(e,t,n){Object.assign(this,{host:e,place:t,stage:n}),new MutationObserver(()=>this.update()).observe(e,Pc),n.addEventListener("shown",()=>this.update())}_known(){let e=new Map,t=[];for(let n of this.host.querySelectorAll(':scope > [slot^="hotspot"]'))try{let{position:s,normal:i}=n.dataset;e.set(n,{position:wi(s??""),normal:i===void 0?null:wi(i)})}catch(s){t.push(`${n.slot}: ${s.message}`)}return this.stage.notices.say(t.join("; "),!0,"hotspots"),e}update(){let e=this._known(),t=new Set([...e.keys()].map(({slot:s})=>s)),n=this.stage.viewer?.shownCamera;for(let s of[...this.place.children])t.has(s.name)||s.remove();for(let[s,i]of e){let o=this._slot(s.slot),c=n&&Fc(n,i.position),l=!!c&&this._isSeen(n,i);o.classList.toggle("unseen",!l),c&&Object.assign(o.style,{left:`${100*c[0]}%`,top:`${100*c[1]}%`}),s.dataset.visibilityAttribute&&s.toggleAttribute(`data-${s.dataset.visibilityAttribute}`,l)}}_slot(e){let t=[...this.place.children].find(s=>s.name===e);if(t)return t;let n=Object.assign(document.createElement("slot"),{name:e});return this.place.append(n),n}_isSeen({position:e},t){let n=xi(t.position,e),s=Math.hypot(...n);if(t.normal&&Vr(t.normal,n)>=0)return!1;let i=Kn(this.stage.arrays,e,bi(n));return!i||i.distance>(1-Lc)*s}};function wi(r){let e=Gr(r);if(e.includes(null))throw new Error(`expected X Y Z, as 0m 0.5m 0m, found ${JSON.stringify(r)}`);return e}var Cc="Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. W, A, S, D or two fingers pan. Square brackets, Shift and arrow keys, or three fingers turn the light. Home resets.";function le(r,e,...t){let n=document.createElement(r);for(let[s,i]of Object.entries(e))n.setAttribute(s,i);return n.append(...t),n}var zc=()=>[le("i",{id:"tint"}),le("div",{id:"view",part:"view"}),le("div",{id:"hotspots"}),le("slot",{}),le("div",{id:"poster"},le("slot",{name:"poster"},le("img",{part:"poster",alt:"",hidden:""}))),le("div",{id:"over"},le("div",{id:"loading",hidden:""},le("slot",{name:"progress-bar"},le("progress",{id:"bar",part:"progress-bar","aria-label":"Loading"}),le("span",{id:"bytes"}))),le("p",{id:"prompt",part:"prompt","aria-hidden":"true",hidden:""},"Drag to turn"),le("p",{id:"notice",part:"notice",role:"alert",hidden:""})),le("p",{id:"keys",class:"spoken"},Cc),le("p",{id:"status",class:"spoken",role:"status"})],Uc=`
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#tint { position: absolute; background-color: inherit; transition: background-color 1ms; }
canvas { display: block; }
canvas:focus-visible { outline: 2px solid #fff; outline-offset: -2px; }
:host([camera-controls]) canvas { cursor: grab; }
:host([camera-controls]) canvas.dragging { cursor: grabbing; }
#hotspots { position: absolute; inset: 0; pointer-events: none; }
#hotspots slot { display: flex; position: absolute; transform: translate(-50%, -50%); pointer-events: auto; }
#hotspots .unseen { visibility: hidden; }
#poster { pointer-events: none; }
::slotted([slot="poster"]) { pointer-events: auto; }
#poster img { object-fit: contain; }
#over {
  position: absolute; inset: 0; padding: 16px; pointer-events: none; overflow: hidden; box-sizing: border-box;
  display: flex; flex-direction: column; justify-content: flex-end; align-items: center; gap: 10px;
}
#loading { text-align: center; font-variant-numeric: tabular-nums; }
#bar {
  display: block; width: min(60vw, 320px); max-width: 100%; height: 4px; margin-bottom: 6px; border: 0; border-radius: 2px;
  appearance: none; background: #3a3a3a;
}
#bar::-webkit-progress-bar { background: #3a3a3a; border-radius: 2px; }
#bar::-webkit-progress-value { background: #cfcfcf; border-radius: 2px; }
#bar::-moz-progress-bar { background: #cfcfcf; border-radius: 2px; }
#notice {
  max-width: min(100%, 60ch); margin: 0; padding: 10px 16px; border-radius: 6px; pointer-events: auto; text-align: center;
  background: #7a2525; border: 1px solid #a34a4a; overflow-wrap: anywhere;
}
#notice.calm { background: #000c; border-color: #555; }
#notice span { display: block; }
#prompt {
  margin: 0 0 8%; padding: 6px 16px; border-radius: 999px; background: #000a; animation: prompt 4s ease-in-out infinite;
}
@keyframes prompt { 0%, 100% { transform: translateX(-24px); opacity: 0; } 20%, 80% { opacity: 1; } 50% { transform: translateX(24px); } }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`,Qn=null;function Ei(r){let e=r.attachShadow({mode:"open",delegatesFocus:!0});return Qn??=new CSSStyleSheet,Qn.cssRules.length||Qn.replaceSync(Uc),e.adoptedStyleSheets=[Qn],e.append(...zc()),e}var Dc=["front","front right","right","back right","back","back left","left","front left"],Ri=20*Math.PI/180;function ki({azimuth:r,elevation:e}){let t=Math.round(4*r/Math.PI),n=Dc[(t%8+8)%8],s=e>Ri?", from above":e<-Ri?", from below":"";return`View from the ${n}${s}`}function*ln(r,e,t){for(let n=r;n<e;n+=8192)t(n,Math.min(e,n+8192)),n+8192<e&&(yield)}async function er(r){for(let e=performance.now();;){let{done:t,value:n}=r.next();if(t)return n;performance.now()-e<20||(await Hc(),e=performance.now())}}function Hc(){let{port1:r,port2:e}=new MessageChannel;return new Promise(t=>{r.onmessage=()=>{r.close(),t()},e.postMessage(null)})}var{words:Xr,members:un}=ue.RnaNode,je=16,Bc=4,Si=256,$c=24;function*Ii(r,e=0){let t=r.length/6,n=Uint32Array.from({length:t},(h,m)=>m),s=new Float32Array(3*t);for(let h=0;h<t;h++)for(let m=0;m<3;m++)s[3*h+m]=.5*(r[6*h+m]+r[6*h+3+m]);let i=new Float32Array(2*Xr*t),o=new Uint32Array(i.buffer),c={boxes:r,centres:s,order:n},l=[[0,t,0,-1]],f=0;for(;l.length;){let[h,m,_,v]=l.pop(),x=Xr*f;f+=1,v>=0&&(o[v+un.child.at]=e+f-1),m-h>Si&&(yield),Gc(c,h,m);for(let D=0;D<3;D++)i[x+un.low.at+D]=ve[D],i[x+un.high.at+D]=ve[3+D];if(m-h<=Bc){o[x+un.child.at]=h,o[x+un.count.at]=m-h;continue}let A={cost:1/0};for(let D=0;D<3&&_<$c;D++){let q=qc(c,h,m,D);q.cost<A.cost&&(A=q),m-h>Si&&(yield)}let N=A.cost<1/0?jc(c,h,m,A):h;h<N&&N<m||(N=Zc(c,h,m)),l.push([N,m,_+1,x],[h,N,_+1,-1])}return{nodes:o.slice(0,Xr*f),order:n}}function ts(r,e,t,n){for(let s=0;s<3;s++)r[e+s]=Math.min(r[e+s],t[n+s]),r[e+3+s]=Math.max(r[e+3+s],t[n+3+s])}function ns(r){for(let e=0;e<r.length;e+=6)for(let t=0;t<3;t++)r[e+t]=1/0,r[e+3+t]=-1/0;return r}var ve=new Float32Array(6),Qr=new Float32Array(6*je),es=new Uint32Array(je),Kr=new Float64Array(je),Jr=new Float64Array(je);function Gc({boxes:r,order:e},t,n){ns(ve);for(let s=t;s<n;s++)ts(ve,0,r,6*e[s])}function Ni({centres:r,order:e},t,n,s){let i=1/0,o=-1/0;for(let c=t;c<n;c++){let l=r[3*e[c]+s];i=Math.min(i,l),o=Math.max(o,l)}return[i,o]}var Oi=(r,e,t)=>Math.min(Math.floor((r-e)/(t-e)*je),je-1);function qc(r,e,t,n){let{boxes:s,centres:i,order:o}=r,[c,l]=Ni(r,e,t,n);if(!(l>c))return{cost:1/0};ns(Qr),es.fill(0);for(let m=e;m<t;m++){let _=Oi(i[3*o[m]+n],c,l);es[_]+=1,ts(Qr,6*_,s,6*o[m])}Ti(Jr,je-1,-1),Ti(Kr,0,1);let f=1/0,h=0;for(let m=1;m<je;m++)Kr[m-1]+Jr[m]<f&&(f=Kr[m-1]+Jr[m],h=m);return{cost:f,cut:h,axis:n,low:c,high:l}}function Ti(r,e,t){ns(ve);for(let n=e,s=0;n>=0&&n<je;n+=t){ts(ve,0,Qr,6*n),s+=es[n];let i=ve[3]-ve[0],o=ve[4]-ve[1],c=ve[5]-ve[2];r[n]=s?(i*o+o*c+c*i)*s:1/0}}function jc({centres:r,order:e},t,n,{axis:s,cut:i,low:o,high:c}){let l=t,f=n-1;for(;l<=f;){let h=e[l];Oi(r[3*h+s],o,c)<i?l++:(e[l]=e[f],e[f--]=h)}return l}function Zc(r,e,t){let{centres:n,order:s}=r,i=[0,1,2].map(c=>{let[l,f]=Ni(r,e,t,c);return f-l}),o=i.indexOf(Math.max(...i));return s.subarray(e,t).sort((c,l)=>n[3*c+o]-n[3*l+o]),Math.floor((e+t)/2)}var{NONE:Yc,OF_NEURAL:Wc,OF_FIBERS:Vc,LETS_THROUGH:Mi,HAS_CUTOFF:Xc}=ie,tr=class{constructor(){Object.assign(this,{surfaces:[],textures:[],images:[],imagesLength:0})}ofFibers(e){return this._add({kind:Vc,part:e})}ofTriangles({mesh:e,transmittance:t,normalMaps:n},s){let i=e.indices.length/3,o=Li(t,i),c=Li(n,i),l=new Map,f=new Uint32Array(i);for(let h=0;h<i;h++){let m=`${c[h]} ${o[h]}`;l.has(m)||l.set(m,this._ofRecords(s,n[c[h]],t[o[h]])),f[h]=l.get(m)}return f}arrays(){let e=this.surfaces.map(i=>ce("Surface",i)),t=Uint32Array.from([...e,...this.textures].flatMap(i=>[...i])),n=new Uint32Array(this.imagesLength),s=0;for(let i of this.images)n.set(i,s),s+=i.length;return{table:t,images:n,texturesAt:e.reduce((i,o)=>i+o.length/4,0),hasTextures:this.textures.length>0,transmits:this.surfaces.some(({flags:i})=>i&Mi)}}_add(e){return this.surfaces.push({normal_map:Yc,...e})-1}_ofRecords(e,t,n){let s={kind:Wc,part:e};return t&&(s.normal_map=this._texture(t.texture)),n&&(s.flags=Mi|(n.cutoff==null?0:Xc),Object.assign(s,{through:this._texture(n.texture),cutoff:n.cutoff??0,ior:n.ior??[0,0]})),this._add(s)}_texture({values:e,width:t,height:n,channels:s}){let i=new Uint32Array(t*n),o=this.imagesLength;for(let c=0;c<i.length;c++){let[l,f=l,h=s===1?l:0]=e.subarray(s*c,s*(c+1));i[c]=l|f<<8|h<<16}return this.images.push(i),this.imagesLength+=i.length,this.textures.push(ce("Texture",{place:o,size:n<<16|t,row_u:[1,0,0],row_v:[0,1,0]}))-1}};function Li(r,e){let t=new Int32Array(e).fill(-1);return r.forEach(({triangles:[n,s]},i)=>t.fill(i,n,n+s)),t}var{RNA_HAS_BEFORE:Kc,RNA_HAS_AFTER:Jc,RNA_IS_SEGMENT:Qc,RNA_SURFACE_SHIFT:Pi}=ie,fn=ue.RnaPrimitive,et=ue.RnaNode,nr=r=>er(el(r));function*el(r){let e=r.map(tl),t=h=>e.reduce((m,_)=>m+_[h],0),n={primitives:new Uint32Array(fn.words*t("primitives")),points:new Float32Array(4*t("points")),normals:new Float32Array(4*t("normals")),boxes:new Float32Array(6*t("primitives")),surfaces:new tr,parts:[],extent:0,strands:0},s={primitive:0,point:0},i=[...r.keys()].sort((h,m)=>(r[h].kind==="fiber")-(r[m].kind==="fiber"));for(let h of i){let m=r[h];n.parts[h]={first:s.primitive,point:s.point,fiber:m.kind==="fiber"},m.kind==="fiber"?yield*rl(n,m.curves,h,s):yield*nl(n,m,h,s),s={primitive:s.primitive+e[h].primitives,point:s.point+e[h].points}}let{nodes:o,order:c}=yield*Ii(n.boxes,1),l=new Uint32Array(n.primitives.length),f=new Uint32Array(c.length);return yield*ln(0,c.length,(h,m)=>{for(let _=h;_<m;_++){let v=c[_],x=n.primitives.subarray(fn.words*v,fn.words*(v+1));l.set(x,fn.words*_),f[v]=_}}),{...n,boxes:null,...n.surfaces.arrays(),primitives:l,nodes:sl(o),where:f,box:il(o)}}function tl({kind:r,mesh:e,curves:t}){if(r==="surface"){let s=e.positions.length/3;return{primitives:e.indices.length/3,points:s,normals:s}}let n=t.radii.length;return{primitives:n-(t.offsets.length-1),points:n,normals:0}}function*nl(r,e,t,{primitive:n,point:s}){let{positions:i,normals:o,uvs:c,indices:l}=e.mesh,{points:f,boxes:h,primitives:m}=r;yield*ln(0,i.length/3,(v,x)=>{for(let A=v;A<x;A++){let N=4*(s+A);for(let D=0;D<3;D++)f[N+D]=i[3*A+D],r.normals[N+D]=o[3*A+D],r.extent=Math.max(r.extent,Math.abs(i[3*A+D]));f[N+3]=c?c[2*A]:0,r.normals[N+3]=c?c[2*A+1]:0}});let _=r.surfaces.ofTriangles(e,t);yield*ln(0,l.length/3,(v,x)=>{for(let A=v;A<x;A++){let N=[0,1,2].map(Q=>l[3*A+Q]),[D,q,X]=N.map(Q=>Q+s);Fi(m,n+A,D,q,X,_[A]<<Pi);for(let Q=0;Q<3;Q++){let xe=N.map(Ne=>i[3*Ne+Q]);h[6*(n+A)+Q]=Math.min(...xe),h[6*(n+A)+3+Q]=Math.max(...xe)}}})}function*rl(r,e,t,{primitive:n,point:s}){let{boxes:i,primitives:o}=r,{radii:c,offsets:l}=e,f=r.surfaces.ofFibers(t);yield*ln(0,c.length,(m,_)=>{for(let v=m;v<_;v++){let[x,A,N]=e.points.subarray(3*v,3*v+3);r.points.set([x,A,N,c[v]],4*(s+v)),r.extent=Math.max(r.extent,Math.max(Math.abs(x),Math.abs(A),Math.abs(N))+c[v])}});let h=n;for(let m=0;m+1<l.length;m++,r.strands++){yield;for(let _=l[m];_+1<l[m+1];_++,h++){let v=(_>l[m]&&Kc)|(_+2<l[m+1]&&Jc);Fi(o,h,s+_,v,r.strands,f<<Pi|Qc);for(let x=0;x<3;x++){let A=e.points[3*_+x],N=e.points[3*_+3+x],D=c[_]*1.0005,q=c[_+1]*1.0005;i[6*h+x]=Math.min(A-D,N-q),i[6*h+3+x]=Math.max(A+D,N+q)}}}}function Fi(r,e,t,n,s,i){let{members:o,words:c}=fn,l=c*e;r[l+o.a.at]=t,r[l+o.b.at]=n,r[l+o.c.at]=s,r[l+o.tag.at]=i}function sl(r){let e=new Uint32Array(r.length+et.words);return e.set(r.subarray(0,et.words)),e[et.members.child.at]=0,e[et.members.count.at]=1,e.set(r,et.words),e}function il(r){let e=new Float32Array(r.buffer,0,et.words),t=({at:n,count:s})=>[...e.subarray(n,n+s)];return{min:t(et.members.low),max:t(et.members.high)}}var Ci=[1024,512];function zi(r){let{rgb:e,width:t,height:n}=cl(r),s=[0,e.length,e.length+n+1,e.length+2*n+3],i=new Float32Array(s[3]+(n+1)*(t+1));i.set(e);let o=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/n))),c=0;for(let l=0;l<=n;l++){let f=o(l)-o(l+1),h=t*Math.max(l-1,0),m=t*Math.min(l,n-1);i[s[1]+l]=f;let _=0;for(let v=0;v<t;v++){let x=(v+1)%t,A=[h+v,h+x,m+v,m+x].reduce((N,D)=>N+ol(e,D),0);_+=A/4*f,i[s[3]+l*(t+1)+v+1]=_}c+=_,i[s[2]+l+1]=c}return{floats:i,places:s,total:c,width:t,height:n,up:al(e,t,n)}}var ol=(r,e)=>.2126*r[3*e]+.7152*r[3*e+1]+.0722*r[3*e+2];function al(r,e,t){let n=[0,0,0];for(let s=0;s<t;s++){let i=Math.PI*(s+.5)/t,o=2*Math.PI**2*Math.sin(i)/(e*t)*Math.max(0,Math.cos(i));for(let c=0;c<3*e;c++)n[c%3]+=r[3*e*s+c]*o}return n}function cl({rgb:r,width:e,height:t}){let n=Math.max(1,Math.ceil(e/Ci[0]),Math.ceil(t/Ci[1]));if(n===1)return{rgb:r,width:e,height:t};let s=Math.ceil(e/n),i=Math.ceil(t/n),o=new Float32Array(3*s*i);for(let c=0;c<i;c++)for(let l=0;l<s;l++){let f=0;for(let h=c*n;h<Math.min(t,(c+1)*n);h++)for(let m=l*n;m<Math.min(e,(l+1)*n);m++,f++)for(let _=0;_<3;_++)o[3*(c*s+l)+_]+=r[3*(h*e+m)+_];for(let h=0;h<3;h++)o[3*(c*s+l)+h]/=f}return{rgb:o,width:s,height:i}}function rr(r){return{rgb:Float32Array.from({length:96},(n,s)=>r[s%3]),width:8,height:4}}function Ui(){let t=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let s=0;s<64;s++){let i=Math.PI*(s+.5)/64;for(let o=0;o<128;o++){let c=2*Math.PI*((o+.5)/128-.5),l=[Math.sin(i)*Math.sin(c),Math.cos(i),-Math.sin(i)*Math.cos(c)],f=.16+.14*Math.max(0,l[1]);for(let h=0;h<3;h++){let m=f*[.95,1,1.08][h];for(let[_,v,x]of n){let A=(l[0]*_[0]+l[1]*_[1]+l[2]*_[2])/Math.hypot(..._);m+=x[h]*Math.min(1,Math.max(0,(A-v)/.03))}t[3*(s*128+o)+h]=m}}}return{rgb:t,width:128,height:64}}function Lt(r){let e=new TextDecoder().decode(r.subarray(0,512)).trimStart();return e.startsWith("version https://git-lfs.github.com/")?"a pointer of Git LFS, in whose place `git lfs pull` puts the file":/^<(!doctype\s+html|html|head|body)\b/i.test(e)?"an HTML page: there is no such file, or it has another address":null}var rs=0,ss=1,is=2,os=3,as=4,cs=5,ls=6,us=7;var fs=1006;var Pt=1015,Ft=1016;var tt=1023;var hn=1028;var Ct=1030;var nt="srgb-linear";var Di=null;function ll(r){let e=r[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=r[1];t&&t.isStackTrace?r[0]+=" "+t.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function Hi(...r){r=ll(r);let e="THREE."+r.shift();if(Di)Di("warn",e,...r);else{let t=r[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...r)}}var Kh={[rs]:rs,[is]:ls,[as]:as,[os]:cs,[ss]:ss,[ls]:is,[us]:us,[cs]:os};var Qh=Math.PI/180,ep=180/Math.PI;function Bi(r,e,t){return Math.max(e,Math.min(t,r))}var Ze=ul();function ul(){let r=new ArrayBuffer(4),e=new Float32Array(r),t=new Uint32Array(r),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){let f=l-127;f<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):f<-14?(n[l]=1024>>-f-14,n[l|256]=1024>>-f-14|32768,s[l]=-f-1,s[l|256]=-f-1):f<=15?(n[l]=f+15<<10,n[l|256]=f+15<<10|32768,s[l]=13,s[l|256]=13):f<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}let i=new Uint32Array(2048),o=new Uint32Array(64),c=new Uint32Array(64);for(let l=1;l<1024;++l){let f=l<<13,h=0;for(;(f&8388608)===0;)f<<=1,h-=8388608;f&=-8388609,h+=947912704,i[l]=f|h}for(let l=1024;l<2048;++l)i[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(c[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:s,mantissaTable:i,exponentTable:o,offsetTable:c}}function fl(r){Math.abs(r)>65504&&Hi("DataUtils.toHalfFloat(): Value out of range."),r=Bi(r,-65504,65504),Ze.floatView[0]=r;let e=Ze.uint32View[0],t=e>>23&511;return Ze.baseTable[t]+((e&8388607)>>Ze.shiftTable[t])}function hl(r){let e=r>>10;return Ze.uint32View[0]=Ze.mantissaTable[Ze.offsetTable[e]+(r&1023)]+Ze.exponentTable[e],Ze.floatView[0]}var M=class{static toHalfFloat(e){return fl(e)}static fromHalfFloat(e){return hl(e)}};var sr=class{};var ye=Uint8Array,zt=Uint16Array,pl=Int32Array,$i=new ye([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Gi=new ye([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),ml=new ye([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),qi=function(r,e){for(var t=new zt(31),n=0;n<31;++n)t[n]=e+=1<<r[n-1];for(var s=new pl(t[30]),n=1;n<30;++n)for(var i=t[n];i<t[n+1];++i)s[i]=i-t[n]<<5|n;return{b:t,r:s}},ji=qi($i,2),Zi=ji.b,dl=ji.r;Zi[28]=258,dl[258]=28;var Yi=qi(Gi,0),gl=Yi.b,cp=Yi.r,ms=new zt(32768);for(V=0;V<32768;++V)Ye=(V&43690)>>1|(V&21845)<<1,Ye=(Ye&52428)>>2|(Ye&13107)<<2,Ye=(Ye&61680)>>4|(Ye&3855)<<4,ms[V]=((Ye&65280)>>8|(Ye&255)<<8)>>1;var Ye,V,pn=(function(r,e,t){for(var n=r.length,s=0,i=new zt(e);s<n;++s)r[s]&&++i[r[s]-1];var o=new zt(e);for(s=1;s<e;++s)o[s]=o[s-1]+i[s-1]<<1;var c;if(t){c=new zt(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var f=s<<4|r[s],h=e-r[s],m=o[r[s]-1]++<<h,_=m|(1<<h)-1;m<=_;++m)c[ms[m]>>l]=f}else for(c=new zt(n),s=0;s<n;++s)r[s]&&(c[s]=ms[o[r[s]-1]++]>>15-r[s]);return c}),mn=new ye(288);for(V=0;V<144;++V)mn[V]=8;var V;for(V=144;V<256;++V)mn[V]=9;var V;for(V=256;V<280;++V)mn[V]=7;var V;for(V=280;V<288;++V)mn[V]=8;var V,Wi=new ye(32);for(V=0;V<32;++V)Wi[V]=5;var V;var _l=pn(mn,9,1);var vl=pn(Wi,5,1),hs=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},ke=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},ps=function(r,e){var t=e/8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},yl=function(r){return(r+7)/8|0},wl=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new ye(r.subarray(e,t))};var xl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Se=function(r,e,t){var n=new Error(e||xl[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,Se),!t)throw n;return n},bl=function(r,e,t,n){var s=r.length,i=n?n.length:0;if(!s||e.f&&!e.l)return t||new ye(0);var o=!t,c=o||e.i!=2,l=e.i;o&&(t=new ye(s*3));var f=function(kn){var Sn=t.length;if(kn>Sn){var Jt=new ye(Math.max(Sn*2,kn));Jt.set(t),t=Jt}},h=e.f||0,m=e.p||0,_=e.b||0,v=e.l,x=e.d,A=e.m,N=e.n,D=s*8;do{if(!v){h=ke(r,m,1);var q=ke(r,m+1,3);if(m+=3,q)if(q==1)v=_l,x=vl,A=9,N=5;else if(q==2){var Ne=ke(r,m,31)+257,We=ke(r,m+10,15)+4,Mr=Ne+ke(r,m+5,31)+1;m+=14;for(var ht=new ye(Mr),De=new ye(19),se=0;se<We;++se)De[ml[se]]=ke(r,m+se*3,7);m+=We*3;for(var An=hs(De),Lr=(1<<An)-1,be=pn(De,An,1),se=0;se<Mr;){var Kt=be[ke(r,m,Lr)];m+=Kt&15;var X=Kt>>4;if(X<16)ht[se++]=X;else{var de=0,Et=0;for(X==16?(Et=3+ke(r,m,3),m+=2,de=ht[se-1]):X==17?(Et=3+ke(r,m,7),m+=3):X==18&&(Et=11+ke(r,m,127),m+=7);Et--;)ht[se++]=de}}var En=ht.subarray(0,Ne),Ae=ht.subarray(Ne);A=hs(En),N=hs(Ae),v=pn(En,A,1),x=pn(Ae,N,1)}else Se(1);else{var X=yl(m)+4,Q=r[X-4]|r[X-3]<<8,xe=X+Q;if(xe>s){l&&Se(0);break}c&&f(_+Q),t.set(r.subarray(X,xe),_),e.b=_+=Q,e.p=m=xe*8,e.f=h;continue}if(m>D){l&&Se(0);break}}c&&f(_+131072);for(var Rn=(1<<A)-1,Pr=(1<<N)-1,ge=m;;ge=m){var de=v[ps(r,m)&Rn],Oe=de>>4;if(m+=de&15,m>D){l&&Se(0);break}if(de||Se(2),Oe<256)t[_++]=Oe;else if(Oe==256){ge=m,v=null;break}else{var Ee=Oe-254;if(Oe>264){var se=Oe-257,He=$i[se];Ee=ke(r,m,(1<<He)-1)+Zi[se],m+=He}var pt=x[ps(r,m)&Pr],Rt=pt>>4;pt||Se(3),m+=pt&15;var Ae=gl[Rt];if(Rt>3){var He=Gi[Rt];Ae+=ps(r,m)&(1<<He)-1,m+=He}if(m>D){l&&Se(0);break}c&&f(_+131072);var J=_+Ee;if(_<Ae){var Be=i-Ae,Ve=Math.min(Ae,J);for(Be+_<0&&Se(3);_<Ve;++_)t[_]=n[Be+_]}for(;_<J;++_)t[_]=t[_-Ae]}}e.l=v,e.p=ge,e.b=_,e.f=h,v&&(h=1,e.m=A,e.d=x,e.n=N)}while(!h);return _!=t.length&&o?wl(t,0,_):t.subarray(0,_)};var Al=new ye(0);var El=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&Se(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&Se(6,"invalid zlib data: "+(r[1]&32?"need":"unexpected")+" dictionary"),(r[1]>>3&4)+2};function Ut(r,e){return bl(r.subarray(El(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Rl=typeof TextDecoder<"u"&&new TextDecoder,kl=0;try{Rl.decode(Al,{stream:!0}),kl=1}catch{}var ir=class extends sr{constructor(e){super(e),this.type=Ft,this.outputFormat=tt,this.part=0}parse(e){let ht=Math.pow(2.7182818,2.2),De=null,se=null;function An(a,u){let p=0;for(let y=0;y<65536;++y)(y==0||a[y>>3]&1<<(y&7))&&(u[p++]=y);let g=p-1;for(;p<65536;)u[p++]=0;return g}function Lr(a){for(let u=0;u<16384;u++)a[u]={},a[u].len=0,a[u].lit=0,a[u].p=null}let be={l:0,c:0,lc:0};function Kt(a,u,p,g,y){for(;p<a;)u=u<<8|ni(g,y),p+=8;p-=a,be.l=u>>p&(1<<a)-1,be.c=u,be.lc=p}let de=new Array(59);function Et(a){for(let p=0;p<=58;++p)de[p]=0;for(let p=0;p<65537;++p)de[a[p]]+=1;let u=0;for(let p=58;p>0;--p){let g=u+de[p]>>1;de[p]=u,u=g}for(let p=0;p<65537;++p){let g=a[p];g>0&&(a[p]=g|de[g]++<<6)}}function En(a,u,p,g,y,E){let d=u,k=0,b=0;for(;g<=y;g++){if(d.value-u.value>p)return!1;Kt(6,k,b,a,d);let R=be.l;if(k=be.c,b=be.lc,E[g]=R,R==63){if(d.value-u.value>p)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");Kt(8,k,b,a,d);let S=be.l+6;if(k=be.c,b=be.lc,g+S>y+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;S--;)E[g++]=0;g--}else if(R>=59){let S=R-59+2;if(g+S>y+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;S--;)E[g++]=0;g--}}Et(E)}function Ae(a){return a&63}function Rn(a){return a>>6}function Pr(a,u,p,g){for(;u<=p;u++){let y=Rn(a[u]),E=Ae(a[u]);if(y>>E)throw new Error("THREE.EXRLoader: Invalid table entry");if(E>14){let d=g[y>>E-14];if(d.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(d.lit++,d.p){let k=d.p;d.p=new Array(d.lit);for(let b=0;b<d.lit-1;++b)d.p[b]=k[b]}else d.p=new Array(1);d.p[d.lit-1]=u}else if(E){let d=0;for(let k=1<<14-E;k>0;k--){let b=g[(y<<14-E)+d];if(b.len||b.p)throw new Error("THREE.EXRLoader: Invalid table entry");b.len=E,b.lit=u,d++}}}return!0}let ge={c:0,lc:0};function Oe(a,u,p,g){a=a<<8|ni(p,g),u+=8,ge.c=a,ge.lc=u}let Ee={c:0,lc:0};function He(a,u,p,g,y,E,d,k,b){if(a==u){g<8&&(Oe(p,g,y,E),p=ge.c,g=ge.lc),g-=8;let R=p>>g;if(R=new Uint8Array([R])[0],k.value+R>b)return!1;let S=d[k.value-1];for(;R-- >0;)d[k.value++]=S}else if(k.value<b)d[k.value++]=a;else return!1;Ee.c=p,Ee.lc=g}function pt(a){return a&65535}function Rt(a){let u=pt(a);return u>32767?u-65536:u}let J={a:0,b:0};function Be(a,u){let p=Rt(a),y=Rt(u),E=p+(y&1)+(y>>1),d=E,k=E-y;J.a=d,J.b=k}function Ve(a,u){let p=pt(a),g=pt(u),y=p-(g>>1)&65535,E=g+y-32768&65535;J.a=E,J.b=y}function kn(a,u,p,g,y,E,d){let k=d<16384,b=p>y?y:p,R=1,S,I;for(;R<=b;)R<<=1;for(R>>=1,S=R,R>>=1;R>=1;){I=0;let T=I+E*(y-S),L=E*R,F=E*S,O=g*R,P=g*S,H,j,B,Y;for(;I<=T;I+=F){let z=I,C=I+g*(p-S);for(;z<=C;z+=P){let U=z+O,K=z+L,W=K+O;k?(Be(a[z+u],a[K+u]),H=J.a,B=J.b,Be(a[U+u],a[W+u]),j=J.a,Y=J.b,Be(H,j),a[z+u]=J.a,a[U+u]=J.b,Be(B,Y),a[K+u]=J.a,a[W+u]=J.b):(Ve(a[z+u],a[K+u]),H=J.a,B=J.b,Ve(a[U+u],a[W+u]),j=J.a,Y=J.b,Ve(H,j),a[z+u]=J.a,a[U+u]=J.b,Ve(B,Y),a[K+u]=J.a,a[W+u]=J.b)}if(p&R){let U=z+L;k?Be(a[z+u],a[U+u]):Ve(a[z+u],a[U+u]),H=J.a,a[U+u]=J.b,a[z+u]=H}}if(y&R){let z=I,C=I+g*(p-S);for(;z<=C;z+=P){let U=z+O;k?Be(a[z+u],a[U+u]):Ve(a[z+u],a[U+u]),H=J.a,a[U+u]=J.b,a[z+u]=H}}S=R,R>>=1}return I}function Sn(a,u,p,g,y,E,d,k,b){let R=0,S=0,I=d,T=Math.trunc(g.value+(y+7)/8);for(;g.value<T;)for(Oe(R,S,p,g),R=ge.c,S=ge.lc;S>=14;){let F=R>>S-14&16383,O=u[F];if(O.len)S-=O.len,He(O.lit,E,R,S,p,g,k,b,I),R=Ee.c,S=Ee.lc;else{if(!O.p)throw new Error("THREE.EXRLoader: hufDecode issues");let P;for(P=0;P<O.lit;P++){let H=Ae(a[O.p[P]]);for(;S<H&&g.value<T;)Oe(R,S,p,g),R=ge.c,S=ge.lc;if(S>=H&&Rn(a[O.p[P]])==(R>>S-H&(1<<H)-1)){S-=H,He(O.p[P],E,R,S,p,g,k,b,I),R=Ee.c,S=Ee.lc;break}}if(P==O.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let L=8-y&7;for(R>>=L,S-=L;S>0;){let F=u[R<<14-S&16383];if(F.len)S-=F.len,He(F.lit,E,R,S,p,g,k,b,I),R=Ee.c,S=Ee.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Jt(a,u,p,g,y,E){let d={value:0},k=p.value,b=pe(u,p),R=pe(u,p);p.value+=4;let S=pe(u,p);if(p.value+=4,b<0||b>=65537||R<0||R>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let I=new Array(65537),T=new Array(16384);Lr(T);let L=g-(p.value-k);if(En(a,p,L,b,R,I),S>8*(g-(p.value-k)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");Pr(I,b,R,T),Sn(I,T,a,p,S,R,E,y,d)}function za(a,u,p){for(let g=0;g<p;++g)u[g]=a[u[g]]}function Tn(a){for(let u=1;u<a.length;u++){let p=a[u-1]+a[u]-128;a[u]=p}}function In(a,u){let p=0,g=Math.floor((a.length+1)/2),y=0,E=a.length-1;for(;!(y>E||(u[y++]=a[p++],y>E));)u[y++]=a[g++]}function Fr(a){let u=a.byteLength,p=new Array,g=0,y=new DataView(a);for(;u>0;){let E=y.getInt8(g++);if(E<0){let d=-E;u-=d+1;for(let k=0;k<d;k++)p.push(y.getUint8(g++))}else{let d=E;u-=2;let k=y.getUint8(g++);for(let b=0;b<d+1;b++)p.push(k)}}return p}function Ua(a,u,p,g,y,E){let d=new DataView(E.buffer),k=p[a.idx[0]].width,b=p[a.idx[0]].height,R=3,S=Math.floor(k/8),I=Math.ceil(k/8),T=Math.ceil(b/8),L=k-(I-1)*8,F=b-(T-1)*8,O={value:0},P=new Array(R),H=new Array(R),j=new Array(R),B=new Array(R),Y=new Array(R);for(let C=0;C<R;++C)Y[C]=u[a.idx[C]],P[C]=C<1?0:P[C-1]+I*T,H[C]=new Float32Array(64),j[C]=new Uint16Array(64),B[C]=new Uint16Array(I*64);for(let C=0;C<T;++C){let U=8;C==T-1&&(U=F);let K=8;for(let $=0;$<I;++$){$==I-1&&(K=L);for(let Z=0;Z<R;++Z)j[Z].fill(0),j[Z][0]=y[P[Z]++],Vs(O,g,j[Z]),Xs(j[Z],H[Z]),Ks(H[Z]);R==3&&Ha(H);for(let Z=0;Z<R;++Z)ei(H[Z],B[Z],$*64)}let W=0;for(let $=0;$<R;++$){let Z=p[a.idx[$]].type;for(let te=8*C;te<8*C+U;++te){W=Y[$][te];for(let me=0;me<S;++me){let ee=me*64+(te&7)*8;d.setUint16(W+0*Z,B[$][ee+0],!0),d.setUint16(W+2*Z,B[$][ee+1],!0),d.setUint16(W+4*Z,B[$][ee+2],!0),d.setUint16(W+6*Z,B[$][ee+3],!0),d.setUint16(W+8*Z,B[$][ee+4],!0),d.setUint16(W+10*Z,B[$][ee+5],!0),d.setUint16(W+12*Z,B[$][ee+6],!0),d.setUint16(W+14*Z,B[$][ee+7],!0),W+=16*Z}}if(S!=I)for(let te=8*C;te<8*C+U;++te){let me=Y[$][te]+8*S*2*Z,ee=S*64+(te&7)*8;for(let Me=0;Me<K;++Me)d.setUint16(me+Me*2*Z,B[$][ee+Me],!0)}}}let z=new Uint16Array(k);d=new DataView(E.buffer);for(let C=0;C<R;++C){p[a.idx[C]].decoded=!0;let U=p[a.idx[C]].type;if(p[C].type==2)for(let K=0;K<b;++K){let W=Y[C][K];for(let $=0;$<k;++$)z[$]=d.getUint16(W+$*2*U,!0);for(let $=0;$<k;++$)d.setFloat32(W+$*2*U,M.fromHalfFloat(z[$]),!0)}}}function Da(a,u,p,g,y,E){let d=new DataView(E.buffer),k=p[a],b=k.width,R=k.height,S=Math.ceil(b/8),I=Math.ceil(R/8),T=Math.floor(b/8),L=b-(S-1)*8,F=R-(I-1)*8,O={value:0},P=0,H=new Float32Array(64),j=new Uint16Array(64),B=new Uint16Array(S*64);for(let Y=0;Y<I;++Y){let z=8;Y==I-1&&(z=F);for(let C=0;C<S;++C)j.fill(0),j[0]=y[P++],Vs(O,g,j),Xs(j,H),Ks(H),ei(H,B,C*64);for(let C=8*Y;C<8*Y+z;++C){let U=u[a][C];for(let K=0;K<T;++K){let W=K*64+(C&7)*8;for(let $=0;$<8;++$)d.setUint16(U+$*2*k.type,B[W+$],!0);U+=16*k.type}if(S!=T){let K=T*64+(C&7)*8;for(let W=0;W<L;++W)d.setUint16(U+W*2*k.type,B[K+W],!0)}}}k.decoded=!0}function Vs(a,u,p){let g,y=1;for(;y<64;)g=u[a.value],g==65280?y=64:g>>8==255?y+=g&255:(p[y]=g,y++),a.value++}function Xs(a,u){u[0]=M.fromHalfFloat(a[0]),u[1]=M.fromHalfFloat(a[1]),u[2]=M.fromHalfFloat(a[5]),u[3]=M.fromHalfFloat(a[6]),u[4]=M.fromHalfFloat(a[14]),u[5]=M.fromHalfFloat(a[15]),u[6]=M.fromHalfFloat(a[27]),u[7]=M.fromHalfFloat(a[28]),u[8]=M.fromHalfFloat(a[2]),u[9]=M.fromHalfFloat(a[4]),u[10]=M.fromHalfFloat(a[7]),u[11]=M.fromHalfFloat(a[13]),u[12]=M.fromHalfFloat(a[16]),u[13]=M.fromHalfFloat(a[26]),u[14]=M.fromHalfFloat(a[29]),u[15]=M.fromHalfFloat(a[42]),u[16]=M.fromHalfFloat(a[3]),u[17]=M.fromHalfFloat(a[8]),u[18]=M.fromHalfFloat(a[12]),u[19]=M.fromHalfFloat(a[17]),u[20]=M.fromHalfFloat(a[25]),u[21]=M.fromHalfFloat(a[30]),u[22]=M.fromHalfFloat(a[41]),u[23]=M.fromHalfFloat(a[43]),u[24]=M.fromHalfFloat(a[9]),u[25]=M.fromHalfFloat(a[11]),u[26]=M.fromHalfFloat(a[18]),u[27]=M.fromHalfFloat(a[24]),u[28]=M.fromHalfFloat(a[31]),u[29]=M.fromHalfFloat(a[40]),u[30]=M.fromHalfFloat(a[44]),u[31]=M.fromHalfFloat(a[53]),u[32]=M.fromHalfFloat(a[10]),u[33]=M.fromHalfFloat(a[19]),u[34]=M.fromHalfFloat(a[23]),u[35]=M.fromHalfFloat(a[32]),u[36]=M.fromHalfFloat(a[39]),u[37]=M.fromHalfFloat(a[45]),u[38]=M.fromHalfFloat(a[52]),u[39]=M.fromHalfFloat(a[54]),u[40]=M.fromHalfFloat(a[20]),u[41]=M.fromHalfFloat(a[22]),u[42]=M.fromHalfFloat(a[33]),u[43]=M.fromHalfFloat(a[38]),u[44]=M.fromHalfFloat(a[46]),u[45]=M.fromHalfFloat(a[51]),u[46]=M.fromHalfFloat(a[55]),u[47]=M.fromHalfFloat(a[60]),u[48]=M.fromHalfFloat(a[21]),u[49]=M.fromHalfFloat(a[34]),u[50]=M.fromHalfFloat(a[37]),u[51]=M.fromHalfFloat(a[47]),u[52]=M.fromHalfFloat(a[50]),u[53]=M.fromHalfFloat(a[56]),u[54]=M.fromHalfFloat(a[59]),u[55]=M.fromHalfFloat(a[61]),u[56]=M.fromHalfFloat(a[35]),u[57]=M.fromHalfFloat(a[36]),u[58]=M.fromHalfFloat(a[48]),u[59]=M.fromHalfFloat(a[49]),u[60]=M.fromHalfFloat(a[57]),u[61]=M.fromHalfFloat(a[58]),u[62]=M.fromHalfFloat(a[62]),u[63]=M.fromHalfFloat(a[63])}function Ks(a){let u=.5*Math.cos(.7853975),p=.5*Math.cos(3.14159/16),g=.5*Math.cos(3.14159/8),y=.5*Math.cos(3*3.14159/16),E=.5*Math.cos(5*3.14159/16),d=.5*Math.cos(3*3.14159/8),k=.5*Math.cos(7*3.14159/16),b=new Array(4),R=new Array(4),S=new Array(4),I=new Array(4);for(let T=0;T<8;++T){let L=T*8;b[0]=g*a[L+2],b[1]=d*a[L+2],b[2]=g*a[L+6],b[3]=d*a[L+6],R[0]=p*a[L+1]+y*a[L+3]+E*a[L+5]+k*a[L+7],R[1]=y*a[L+1]-k*a[L+3]-p*a[L+5]-E*a[L+7],R[2]=E*a[L+1]-p*a[L+3]+k*a[L+5]+y*a[L+7],R[3]=k*a[L+1]-E*a[L+3]+y*a[L+5]-p*a[L+7],S[0]=u*(a[L+0]+a[L+4]),S[3]=u*(a[L+0]-a[L+4]),S[1]=b[0]+b[3],S[2]=b[1]-b[2],I[0]=S[0]+S[1],I[1]=S[3]+S[2],I[2]=S[3]-S[2],I[3]=S[0]-S[1],a[L+0]=I[0]+R[0],a[L+1]=I[1]+R[1],a[L+2]=I[2]+R[2],a[L+3]=I[3]+R[3],a[L+4]=I[3]-R[3],a[L+5]=I[2]-R[2],a[L+6]=I[1]-R[1],a[L+7]=I[0]-R[0]}for(let T=0;T<8;++T)b[0]=g*a[16+T],b[1]=d*a[16+T],b[2]=g*a[48+T],b[3]=d*a[48+T],R[0]=p*a[8+T]+y*a[24+T]+E*a[40+T]+k*a[56+T],R[1]=y*a[8+T]-k*a[24+T]-p*a[40+T]-E*a[56+T],R[2]=E*a[8+T]-p*a[24+T]+k*a[40+T]+y*a[56+T],R[3]=k*a[8+T]-E*a[24+T]+y*a[40+T]-p*a[56+T],S[0]=u*(a[T]+a[32+T]),S[3]=u*(a[T]-a[32+T]),S[1]=b[0]+b[3],S[2]=b[1]-b[2],I[0]=S[0]+S[1],I[1]=S[3]+S[2],I[2]=S[3]-S[2],I[3]=S[0]-S[1],a[0+T]=I[0]+R[0],a[8+T]=I[1]+R[1],a[16+T]=I[2]+R[2],a[24+T]=I[3]+R[3],a[32+T]=I[3]-R[3],a[40+T]=I[2]-R[2],a[48+T]=I[1]-R[1],a[56+T]=I[0]-R[0]}function Ha(a){for(let u=0;u<64;++u){let p=a[0][u],g=a[1][u],y=a[2][u];a[0][u]=p+1.5747*y,a[1][u]=p-.1873*g-.4682*y,a[2][u]=p+1.8556*g}}let Cr=new Float32Array(1),Js=new Uint32Array(Cr.buffer);function Qs(a){Cr[0]=a;let u=Js[0],p=u>>>16&32768,g=u&2147483647;if(g>=1199570944)return p|(g>2139095040?32256:31744);if(g<947912704)return Cr[0]=Math.abs(a)+.5,p|Js[0]-1056964608;let y=g+4095+(g>>>13&1);return p|y-939524096>>>13}function ei(a,u,p){if(se===null){se=new Uint16Array(65536);for(let g=1;g<65536;++g){if((g&31744)===31744)continue;let y=M.fromHalfFloat(g),E=Math.abs(y),d=E<=1?Math.pow(E,2.2):Math.pow(ht,E-1);se[g]=Qs(y<0?-d:d)}}for(let g=0;g<64;++g)u[p+g]=se[Qs(a[g])]}function Nn(a){return new DataView(a.array.buffer,a.offset.value,a.size)}function Ba(a){let u=a.viewer.buffer.slice(a.offset.value,a.offset.value+a.size),p=new Uint8Array(Fr(u)),g=new Uint8Array(p.length);return Tn(p),In(p,g),new DataView(g.buffer)}function zr(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Ut(u),g=new Uint8Array(p.length);return Tn(p),In(p,g),new DataView(g.buffer)}function $a(a){let u=a.viewer,p={value:a.offset.value},g=new Uint16Array(a.columns*a.lines*(a.inputChannels.length*a.type)),y=new Uint8Array(8192),E=0,d=new Array(a.inputChannels.length);for(let F=0,O=a.inputChannels.length;F<O;F++)d[F]={},d[F].start=E,d[F].end=d[F].start,d[F].nx=a.columns,d[F].ny=a.lines,d[F].size=a.type,E+=d[F].nx*d[F].ny*d[F].size;let k=Qt(u,p),b=Qt(u,p);if(b>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(k<=b)for(let F=0;F<b-k+1;F++)y[F+k]=Xe(u,p);let R=new Uint16Array(65536),S=An(y,R),I=pe(u,p);Jt(a.array,u,p,I,g,E);for(let F=0;F<a.inputChannels.length;++F){let O=d[F];for(let P=0;P<d[F].size;++P)kn(g,O.start+P,O.nx,O.size,O.ny,O.nx*O.size,S)}za(R,g,E);let T=0,L=new Uint8Array(g.buffer.byteLength);for(let F=0;F<a.lines;F++)for(let O=0;O<a.inputChannels.length;O++){let P=d[O],H=P.nx*P.size,j=new Uint8Array(g.buffer,P.end*2,H*2);L.set(j,T),T+=H*2,P.end+=H}return new DataView(L.buffer)}function Ga(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Ut(u),g=a.inputChannels.length*a.lines*a.columns*a.totalBytes,y=new ArrayBuffer(g),E=new DataView(y),d=0,k=0,b=new Array(4);for(let R=0;R<a.lines;R++)for(let S=0;S<a.inputChannels.length;S++){let I=0;switch(a.inputChannels[S].pixelType){case 1:b[0]=d,b[1]=b[0]+a.columns,d=b[1]+a.columns;for(let L=0;L<a.columns;++L){let F=p[b[0]++]<<8|p[b[1]++];I+=F,E.setUint16(k,I,!0),k+=2}break;case 2:b[0]=d,b[1]=b[0]+a.columns,b[2]=b[1]+a.columns,d=b[2]+a.columns;for(let L=0;L<a.columns;++L){let F=p[b[0]++]<<24|p[b[1]++]<<16|p[b[2]++]<<8;I+=F,E.setUint32(k,I,!0),k+=4}break}}return E}function qa(a){let u=a.array,p=a.offset.value,g=a.columns,y=a.lines,E=a.inputChannels,d=a.totalBytes,k=ae.compression==="B44A_COMPRESSION",b=new Uint8Array(y*g*d),R=new Uint16Array(16),S=0;for(let I=0;I<E.length;I++){let T=E[I],L=T.pixelType*2,F=Math.ceil(g/T.xSampling),O=Math.ceil(y/T.ySampling),P=T.xSampling===1&&T.ySampling===1;if(T.pixelType!==1){for(let B=0;B<O;B++)if(P){let Y=B*g*d+S*g;for(let z=0;z<F*L;z++)b[Y+z]=u[p++]}else p+=F*L;S+=L;continue}let H=Math.ceil(F/4),j=Math.ceil(O/4);for(let B=0;B<j;B++)for(let Y=0;Y<H;Y++){if(k&&u[p+2]>=52){let z=u[p]<<8|u[p+1],C=z&32768?z&32767:~z&65535;R.fill(C),p+=3}else{let z=u[p]<<8|u[p+1],C=u[p+2]>>2,U=32<<C,K=z+((u[p+2]<<4|u[p+3]>>4)&63)*(1<<C)-U&65535,W=K+((u[p+3]<<2|u[p+4]>>6)&63)*(1<<C)-U&65535,$=W+(u[p+4]&63)*(1<<C)-U&65535,Z=z+(u[p+5]>>2&63)*(1<<C)-U&65535,te=K+((u[p+5]<<4|u[p+6]>>4)&63)*(1<<C)-U&65535,me=W+((u[p+6]<<2|u[p+7]>>6)&63)*(1<<C)-U&65535,ee=$+(u[p+7]&63)*(1<<C)-U&65535,Me=Z+(u[p+8]>>2&63)*(1<<C)-U&65535,kt=te+((u[p+8]<<4|u[p+9]>>4)&63)*(1<<C)-U&65535,en=me+((u[p+9]<<2|u[p+10]>>6)&63)*(1<<C)-U&65535,Le=ee+(u[p+10]&63)*(1<<C)-U&65535,mt=Me+(u[p+11]>>2&63)*(1<<C)-U&65535,Fn=kt+((u[p+11]<<4|u[p+12]>>4)&63)*(1<<C)-U&65535,Cn=en+((u[p+12]<<2|u[p+13]>>6)&63)*(1<<C)-U&65535,zn=Le+(u[p+13]&63)*(1<<C)-U&65535,tn=[z,Z,Me,mt,K,te,kt,Fn,W,me,en,Cn,$,ee,Le,zn];for(let St=0;St<16;St++)R[St]=tn[St]&32768?tn[St]&32767:~tn[St]&65535;p+=14}if(T.pLinear){if(De===null){De=new Uint16Array(65536);for(let z=0;z<65536;z++)if((z&31744)===31744||z>32768)De[z]=0;else{let C=M.fromHalfFloat(z);De[z]=C<=0?0:M.toHalfFloat(8*Math.log(C))}}for(let z=0;z<16;z++)R[z]=De[R[z]]}for(let z=0;z<4;z++){let C=B*4+z;if(!(C>=O))for(let U=0;U<4;U++){let K=Y*4+U;if(K>=F)continue;let W=R[z*4+U];for(let $=0;$<T.ySampling;$++){let Z=C*T.ySampling+$;if(!(Z>=y))for(let te=0;te<T.xSampling;te++){let me=K*T.xSampling+te;if(me>=g)continue;let ee=Z*g*d+S*g+me*2;b[ee]=W&255,b[ee+1]=W>>8&255}}}}}S+=2}return new DataView(b.buffer)}function ti(a){let u=a.viewer,p={value:a.offset.value},g=new Uint8Array(a.columns*a.lines*(a.inputChannels.length*a.type*2)),y={version:re(u,p),unknownUncompressedSize:re(u,p),unknownCompressedSize:re(u,p),acCompressedSize:re(u,p),dcCompressedSize:re(u,p),rleCompressedSize:re(u,p),rleUncompressedSize:re(u,p),rleRawSize:re(u,p),totalAcUncompressedCount:re(u,p),totalDcUncompressedCount:re(u,p),acCompression:re(u,p)};if(y.version<2)throw new Error("THREE.EXRLoader: "+ae.compression+" version "+y.version+" is unsupported");let E=new Array,d=Qt(u,p)-2;for(;d>0;){let O=On(u.buffer,p),P=Xe(u,p),H=P>>2&3,j=(P>>4)-1,B=new Int8Array([j])[0],Y=Xe(u,p);E.push({name:O,index:B,type:Y,compression:H}),d-=O.length+3}let k=ae.channels,b=new Array(a.inputChannels.length);for(let O=0;O<a.inputChannels.length;++O){let P=b[O]={},H=k[O];P.name=H.name,P.compression=0,P.decoded=!1,P.type=H.pixelType,P.pLinear=H.pLinear,P.width=a.columns,P.height=a.lines}let R={idx:new Array(3)};for(let O=0;O<a.inputChannels.length;++O){let P=b[O],H=P.name.lastIndexOf("."),j=H>=0?P.name.substring(H+1):P.name;for(let B=0;B<E.length;++B){let Y=E[B];j===Y.name&&P.type===Y.type&&(P.compression=Y.compression,Y.index>=0&&(R.idx[Y.index]=O),P.offset=O)}}let S,I,T;if(y.acCompressedSize>0)switch(y.acCompression){case 0:S=new Uint16Array(y.totalAcUncompressedCount),Jt(a.array,u,p,y.acCompressedSize,S,y.totalAcUncompressedCount);break;case 1:let O=a.array.slice(p.value,p.value+y.totalAcUncompressedCount),P=Ut(O);S=new Uint16Array(P.buffer),p.value+=y.totalAcUncompressedCount;break}if(y.dcCompressedSize>0){let O={array:a.array,offset:p,size:y.dcCompressedSize};I=new Uint16Array(zr(O).buffer),p.value+=y.dcCompressedSize}if(y.rleRawSize>0){let O=a.array.slice(p.value,p.value+y.rleCompressedSize),P=Ut(O);T=Fr(P.buffer),p.value+=y.rleCompressedSize}let L=0,F=new Array(b.length);for(let O=0;O<F.length;++O)F[O]=new Array;for(let O=0;O<a.lines;++O)for(let P=0;P<b.length;++P)F[P].push(L),L+=b[P].width*a.type*2;R.idx[0]!==void 0&&b[R.idx[0]]&&Ua(R,F,b,S,I,g);for(let O=0;O<b.length;++O){let P=b[O];if(!P.decoded)switch(P.compression){case 2:let H=0,j=0;for(let B=0;B<a.lines;++B){let Y=F[O][H];for(let z=0;z<P.width;++z){for(let C=0;C<2*P.type;++C)g[Y++]=T[j+C*P.width*P.height];j++}H++}break;case 1:Da(O,F,b,S,I,g);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(g.buffer)}function On(a,u){let p=new Uint8Array(a),g=0;for(;p[u.value+g]!=0;)g+=1;let y=new TextDecoder().decode(p.slice(u.value,u.value+g));return u.value=u.value+g+1,y}function ja(a,u,p){let g=new TextDecoder().decode(new Uint8Array(a).slice(u.value,u.value+p));return u.value=u.value+p,g}function Za(a,u){let p=fe(a,u),g=pe(a,u);return[p,g]}function Ya(a,u){let p=pe(a,u),g=pe(a,u);return[p,g]}function fe(a,u){let p=a.getInt32(u.value,!0);return u.value=u.value+4,p}function pe(a,u){let p=a.getUint32(u.value,!0);return u.value=u.value+4,p}function ni(a,u){let p=a[u.value];return u.value=u.value+1,p}function Xe(a,u){let p=a.getUint8(u.value);return u.value=u.value+1,p}let re=function(a,u){let p=Number(a.getBigInt64(u.value,!0));return u.value+=8,p};function oe(a,u){let p=a.getFloat32(u.value,!0);return u.value+=4,p}function Wa(a,u){return M.toHalfFloat(oe(a,u))}function Qt(a,u){let p=a.getUint16(u.value,!0);return u.value+=2,p}function Va(a,u){return M.fromHalfFloat(Qt(a,u))}function Xa(a,u,p,g){let y=p.value,E=[];for(;p.value<y+g-1;){let d=On(u,p),k=fe(a,p),b=Xe(a,p);p.value+=3;let R=fe(a,p),S=fe(a,p);E.push({name:d,pixelType:k,pLinear:b,xSampling:R,ySampling:S})}return p.value+=1,E}function Ka(a,u){let p=oe(a,u),g=oe(a,u),y=oe(a,u),E=oe(a,u),d=oe(a,u),k=oe(a,u),b=oe(a,u),R=oe(a,u);return{redX:p,redY:g,greenX:y,greenY:E,blueX:d,blueY:k,whiteX:b,whiteY:R}}function Ja(a,u){let p=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],g=Xe(a,u);return p[g]}function Qa(a,u){let p=fe(a,u),g=fe(a,u),y=fe(a,u),E=fe(a,u);return{xMin:p,yMin:g,xMax:y,yMax:E}}function ec(a,u){let p=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],g=Xe(a,u);return p[g]}function tc(a,u){let p=["ENVMAP_LATLONG","ENVMAP_CUBE"],g=Xe(a,u);return p[g]}function nc(a,u){let p=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],g=["ROUND_DOWN","ROUND_UP"],y=pe(a,u),E=pe(a,u),d=Xe(a,u);return{xSize:y,ySize:E,levelMode:p[d&15],roundingMode:g[d>>4]}}function rc(a,u){let p=oe(a,u),g=oe(a,u);return[p,g]}function sc(a,u){let p=oe(a,u),g=oe(a,u),y=oe(a,u);return[p,g,y]}function ic(a,u,p,g,y){if(g==="string"||g==="stringvector"||g==="iccProfile")return ja(u,p,y);if(g==="chlist")return Xa(a,u,p,y);if(g==="chromaticities")return Ka(a,p);if(g==="compression")return Ja(a,p);if(g==="box2i")return Qa(a,p);if(g==="envmap")return tc(a,p);if(g==="tiledesc")return nc(a,p);if(g==="lineOrder")return ec(a,p);if(g==="float")return oe(a,p);if(g==="v2f")return rc(a,p);if(g==="v3f")return sc(a,p);if(g==="int")return fe(a,p);if(g==="rational")return Za(a,p);if(g==="timecode")return Ya(a,p);if(g==="preview"||g==="deepImageState"||g==="idmanifest")return p.value+=y,"skipped";p.value+=y}function oc(a,u){let p=Math.log2(a);return u=="ROUND_DOWN"?Math.floor(p):Math.ceil(p)}function ac(a,u,p){let g=0;switch(a.levelMode){case"ONE_LEVEL":g=1;break;case"MIPMAP_LEVELS":g=oc(Math.max(u,p),a.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return g}function ri(a,u,p,g){let y=new Array(a);for(let E=0;E<a;E++){let d=1<<E,k=u/d|0;g=="ROUND_UP"&&k*d<u&&(k+=1);let b=Math.max(k,1);y[E]=(b+p-1)/p|0}return y}function cc(){let a=this,u=a.offset,p={value:0};for(let g=0;g<a.tileCount;g++){let y=fe(a.viewer,u),E=fe(a.viewer,u);u.value+=8,a.size=pe(a.viewer,u);let d=y*a.blockWidth,k=E*a.blockHeight;a.columns=d+a.blockWidth>a.width?a.width-d:a.blockWidth,a.lines=k+a.blockHeight>a.height?a.height-k:a.blockHeight;let b=a.columns*a.totalBytes,S=a.size<a.lines*b?a.uncompress(a):Nn(a);u.value+=a.size;for(let I=0;I<a.lines;I++){let T=I*a.columns*a.totalBytes;for(let L=0;L<a.inputChannels.length;L++){let F=ae.channels[L].name,O=a.channelByteOffsets[F]*a.columns,P=a.decodeChannels[F];if(P===void 0)continue;p.value=T+O;let H=(a.height-(1+k+I))*a.outLineWidth;for(let j=0;j<a.columns;j++){let B=H+(j+d)*a.outputChannels+P;a.byteArray[B]=a.getter(S,p)}}}}}function lc(){let a=this,u=a.offset,p={value:0};for(let g=0;g<a.height/a.blockHeight;g++){let y=fe(a.viewer,u)-ae.dataWindow.yMin;a.size=pe(a.viewer,u),a.lines=y+a.blockHeight>a.height?a.height-y:a.blockHeight;let E=a.columns*a.totalBytes,k=a.size<a.lines*E?a.uncompress(a):Nn(a);u.value+=a.size;for(let b=0;b<a.lines;b++){let R=y+b,S=b*E,I=(a.height-1-R)*a.outLineWidth;for(let T=0;T<a.inputChannels.length;T++){let L=ae.channels[T].name,F=a.channelByteOffsets[L]*a.columns,O=a.decodeChannels[L];if(O!==void 0){p.value=S+F;for(let P=0;P<a.columns;P++){let H=I+P*a.outputChannels+O;a.byteArray[H]=a.getter(k,p)}}}}}}function uc(){let a=this,u=a.chunkOffsets,p={value:0};for(let g=0;g<u.length;g++){let y={value:u[g]};y.value+=4;let E=fe(a.viewer,y)-ae.dataWindow.yMin;a.size=pe(a.viewer,y),a.lines=E+a.blockHeight>a.height?a.height-E:a.blockHeight;let d=a.columns*a.totalBytes,k=a.size<a.lines*d,b=a.offset;a.offset=y;let R=k?a.uncompress(a):Nn(a);a.offset=b;for(let S=0;S<a.lines;S++){let I=E+S,T=S*d,L=(a.height-1-I)*a.outLineWidth;for(let F=0;F<a.inputChannels.length;F++){let O=ae.channels[F].name,P=a.channelByteOffsets[O]*a.columns,H=a.decodeChannels[O];if(H!==void 0){p.value=T+P;for(let j=0;j<a.columns;j++){let B=L+j*a.outputChannels+H;a.byteArray[B]=a.getter(R,p)}}}}}}function si(a,u,p,g){if(p===0)return null;let y=a.slice(u,u+p);switch(g){case"NO_COMPRESSION":return new DataView(y.buffer,y.byteOffset,y.byteLength);case"RLE_COMPRESSION":{let E=new Uint8Array(Fr(y.buffer.slice(y.byteOffset,y.byteOffset+y.byteLength))),d=new Uint8Array(E.length);return Tn(E),In(E,d),new DataView(d.buffer)}case"ZIPS_COMPRESSION":{let E=Ut(y),d=new Uint8Array(E.length);return Tn(E),In(E,d),new DataView(d.buffer)}default:throw new Error("THREE.EXRLoader: "+g+" is unsupported for deep data")}}function fc(){let a=this,u=a.chunkOffsets,p=a.width,g=a.height,y=a.deepChannels,E=ae.compression,d=a.multiPart,k=a.decodeChannels,b=a.outputChannels,R=a.byteArray instanceof Uint16Array,S=-1;for(let I=0;I<y.length;I++)if(y[I].name==="A"){S=I;break}for(let I=0;I<u.length;I++){let T={value:u[I]};d&&(T.value+=4);let L=fe(a.viewer,T)-ae.dataWindow.yMin,F=re(a.viewer,T),O=re(a.viewer,T);re(a.viewer,T);let P=si(a.array,T.value,F,E);if(T.value+=F,P===null)continue;let H=new Uint32Array(p);for(let U=0;U<p;U++)H[U]=P.getUint32(U*4,!0);let j=H[p-1];if(j===0){T.value+=O;continue}let B=si(a.array,T.value,O,E),Y=[],z=0;for(let U=0;U<y.length;U++)Y.push(z),z+=j*y[U].bytesPerSample;let C=(g-1-L)*a.outLineWidth;for(let U=0;U<p;U++){let K=U===0?0:H[U-1],$=H[U]-K;if($===0)continue;let Z=new Float32Array(b),te=0;for(let ee=0;ee<$;ee++){let Me=K+ee,kt=1-te;if(kt<=0)break;let en=1;if(S>=0){let Le=y[S].bytesPerSample,mt=Y[S]+Me*Le;en=Le===2?M.fromHalfFloat(B.getUint16(mt,!0)):B.getFloat32(mt,!0)}for(let Le=0;Le<y.length;Le++){let mt=y[Le],Fn=k[mt.name];if(Fn===void 0)continue;let Cn=mt.bytesPerSample,zn=Y[Le]+Me*Cn,tn=Cn===2?M.fromHalfFloat(B.getUint16(zn,!0)):B.getFloat32(zn,!0);Z[Fn]+=tn*kt}te+=en*kt}k.A!==void 0&&(Z[k.A]=te);let me=C+U*b;for(let ee=0;ee<b;ee++)a.byteArray[me+ee]=R?M.toHalfFloat(Z[ee]):Z[ee]}}}function ii(a,u,p){let g={},y=!1;for(;;){let E=On(u,p);if(E==="")break;y=!0;let d=On(u,p),k=pe(a,p),b=ic(a,u,p,d,k);b===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${d}'.`):g[E]=b}return y?g:null}function hc(a,u,p){if(a.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let g=a.getUint8(4),y=a.getUint8(5),E={singleTile:!!(y&2),longName:!!(y&4),deepFormat:!!(y&8),multiPart:!!(y&16)};p.value=8;let d=[];if(E.multiPart){for(;;){let k=ii(a,u,p);if(k===null)break;k.version=g,k.spec=E,d.push(k)}if(d.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let k=ii(a,u,p);k.version=g,k.spec=E,d.push(k)}return d}function pc(a,u,p,g,y,E){let d={size:0,viewer:u,array:p,offset:g,width:a.dataWindow.xMax-a.dataWindow.xMin+1,height:a.dataWindow.yMax-a.dataWindow.yMin+1,inputChannels:a.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:nt};switch(a.compression){case"NO_COMPRESSION":d.blockHeight=1,d.uncompress=Nn;break;case"RLE_COMPRESSION":d.blockHeight=1,d.uncompress=Ba;break;case"ZIPS_COMPRESSION":d.blockHeight=1,d.uncompress=zr;break;case"ZIP_COMPRESSION":d.blockHeight=16,d.uncompress=zr;break;case"PIZ_COMPRESSION":d.blockHeight=32,d.uncompress=$a;break;case"PXR24_COMPRESSION":d.blockHeight=16,d.uncompress=Ga;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":d.blockHeight=32,d.uncompress=qa;break;case"DWAA_COMPRESSION":d.blockHeight=32,d.uncompress=ti;break;case"DWAB_COMPRESSION":d.blockHeight=256,d.uncompress=ti;break;default:throw new Error("THREE.EXRLoader: "+a.compression+" is unsupported")}let k={};for(let T of a.channels)switch(T.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":k[T.name]=!0,d.type=T.pixelType}let b=!1,R=!1;if(k.Y&&k.RY&&k.BY)d.outputChannels=4,d.yCbCr=!0;else if(k.R&&k.G&&k.B)d.outputChannels=4;else if(k.Y)d.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(d.outputChannels){case 4:E==tt?(b=!k.A,d.format=tt,d.colorSpace=nt,d.outputChannels=4,d.decodeChannels={R:0,G:1,B:2,A:3}):E==Ct?(d.format=Ct,d.colorSpace=nt,d.outputChannels=2,d.decodeChannels={R:0,G:1}):E==hn?(d.format=hn,d.colorSpace=nt,d.outputChannels=1,d.decodeChannels={R:0}):R=!0;break;case 1:E==tt?(b=!0,d.format=tt,d.colorSpace=nt,d.outputChannels=4,d.shouldExpand=!0,d.decodeChannels={Y:0}):E==Ct?(d.format=Ct,d.colorSpace=nt,d.outputChannels=2,d.shouldExpand=!0,d.decodeChannels={Y:0}):E==hn?(d.format=hn,d.colorSpace=nt,d.outputChannels=1,d.decodeChannels={Y:0}):R=!0;break;default:R=!0}if(R)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(d.yCbCr&&(d.format=tt,d.outputChannels=4,d.decodeChannels={Y:0,RY:1,BY:2},b=!0),d.type==1)switch(y){case Pt:d.getter=Va;break;case Ft:d.getter=Qt;break}else if(d.type==2)switch(y){case Pt:d.getter=oe;break;case Ft:d.getter=Wa}else throw new Error("THREE.EXRLoader: unsupported pixelType "+d.type+" for "+a.compression+".");d.columns=d.width;let S=d.width*d.height*d.outputChannels;switch(y){case Pt:d.byteArray=new Float32Array(S),b&&d.byteArray.fill(1,0,S);break;case Ft:d.byteArray=new Uint16Array(S),b&&d.byteArray.fill(15360,0,S);break;default:console.error("THREE.EXRLoader: unsupported type: ",y);break}let I=0;for(let T of a.channels)d.decodeChannels[T.name]!==void 0&&(d.channelByteOffsets[T.name]=I),I+=T.pixelType*2;if(d.totalBytes=I,d.outLineWidth=d.width*d.outputChannels,a.spec.deepFormat){d.deepChannels=[];let T=0;for(let L of a.channels){let F=L.pixelType===0?4:L.pixelType*2;d.deepChannels.push({name:L.name,pixelType:L.pixelType,bytesPerSample:F}),T+=F}d.deepBytesPerSample=T,d.chunkOffsets=a._chunkOffsets,d.multiPart=a.spec.multiPart,d.decode=fc.bind(d)}else if(a.spec.singleTile){d.blockHeight=a.tiles.ySize,d.blockWidth=a.tiles.xSize;let T=ac(a.tiles,d.width,d.height),L=ri(T,d.width,a.tiles.xSize,a.tiles.roundingMode),F=ri(T,d.height,a.tiles.ySize,a.tiles.roundingMode);d.tileCount=L[0]*F[0];for(let O=0;O<T;O++)for(let P=0;P<F[O];P++)for(let H=0;H<L[O];H++)re(u,g);d.decode=cc.bind(d)}else if(a.spec.multiPart)d.blockWidth=d.width,d.chunkOffsets=a._chunkOffsets,d.decode=uc.bind(d);else{d.blockWidth=d.width;let T=Math.ceil(d.height/d.blockHeight);for(let L=0;L<T;L++)re(u,g);d.decode=lc.bind(d)}return d}let Mn={value:0},Ln=new DataView(e),mc=new Uint8Array(e),Pn=hc(Ln,e,Mn),oi=Math.max(0,Math.min(this.part,Pn.length-1)),ae=Pn[oi];if(ae.spec.multiPart||ae.spec.deepFormat)for(let a=0;a<Pn.length;a++){let u=Pn[a].chunkCount;if(a===oi){ae._chunkOffsets=[];for(let p=0;p<u;p++)ae._chunkOffsets.push(re(Ln,Mn))}else for(let p=0;p<u;p++)re(Ln,Mn)}let _e=pc(ae,Ln,mc,Mn,this.type,this.outputFormat);if(_e.decode(),_e.shouldExpand){let a=_e.byteArray;if(this.outputFormat==tt)for(let u=0;u<a.length;u+=4)a[u+2]=a[u+1]=a[u];else if(this.outputFormat==Ct)for(let u=0;u<a.length;u+=2)a[u+1]=a[u]}if(_e.yCbCr){let a=_e.byteArray,u=_e.width*_e.height;if(this.type===Ft)for(let p=0;p<u;p++){let g=p*4,y=M.fromHalfFloat(a[g]),E=M.fromHalfFloat(a[g+1]),d=M.fromHalfFloat(a[g+2]),k=(1+E)*y,b=(1+d)*y,R=(y-k*.2126-b*.0722)/.7152;a[g]=M.toHalfFloat(Math.max(0,k)),a[g+1]=M.toHalfFloat(Math.max(0,R)),a[g+2]=M.toHalfFloat(Math.max(0,b))}else for(let p=0;p<u;p++){let g=p*4,y=a[g],E=a[g+1],d=a[g+2],k=(1+E)*y,b=(1+d)*y;a[g]=Math.max(0,k),a[g+1]=Math.max(0,(y-k*.2126-b*.0722)/.7152),a[g+2]=Math.max(0,b)}}return{header:ae,width:_e.width,height:_e.height,data:_e.byteArray,format:_e.format,colorSpace:_e.colorSpace,type:this.type,minFilter:fs,magFilter:fs,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Vi=32768,Sl=2**27,Xi=2**28,Ki=1024,Tl=12,ds=2**29,Ji=1e18;function or(r,e,t){let n=Math.max(r,e)>Vi||r*e>Sl;if(Math.min(r,e)<1||n)throw new G(`has ${r} x ${e} pixels; from 1 to ${Vi} a side, 2^27 in all`);let s=r*e*Tl;if(s>Xi&&s>Ki*t)throw new G(`has ${r} x ${e} pixels in ${t} bytes; an image above ${Xi} bytes of radiance is at most ${Ki} times its file`)}var Il=512,Nl=2048,Ol=4096,cr=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],Ml=0,Ll=2,Pl=2,Fl=4096,Qi=["RY","BY"];function eo(r){let{parts:e,flags:t}=Bl(r),n=zl(e),s=e[n];Ul(s,e.length,t);for(let q of[s.dataWindow,s.displayWindow])or(...ar(q),r.length);let i=e.reduce((q,X)=>q+Math.max(0,Cl(X)),0);if(i>ds)throw new G(`has ${i} values in all its channels; at most ${ds}`);let o=s.dataWindow,c=s.displayWindow,l=Math.max(o[0],c[0]),f=Math.min(o[2],c[2]),h=Math.max(o[1],c[1]),m=Math.min(o[3],c[3]);if(l>f||h>m)throw new G("its data window lies outside its display window");Dl(s);let v=new ir().setDataType(Pt).setPart(n).parse(Hl(r,s).buffer),[x,A]=ar(c),[N]=ar(o),D=new Float32Array(3*x*A);for(let q=h;q<=m;q++){let X=o[3]-q;for(let Q=l;Q<=f;Q++){let xe=4*(X*N+Q-o[0]),Ne=3*((q-c[1])*x+Q-c[0]);for(let We=0;We<3;We++)D[Ne+We]=v.data[xe+We]}}return{rgb:D,width:x,height:A}}function ar([r,e,t,n]){return[t-r+1,n-e+1]}function Cl({dataWindow:r,channels:e}){let[t,n]=ar(r);return Math.max(0,t)*Math.max(0,n)*e.length}function _s({channels:r}){let e=new Set(r.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!Qi.some(t=>e.has(t))?["Y"]:[]}function zl(r){let e=r.findIndex(s=>_s(s).length>0);if(e>=0)return e;let t=[...new Set(r.flatMap(({channels:s})=>s.map(({name:i})=>i)))].sort();if(["Y",...Qi].every(s=>t.includes(s)))throw new G("has luminance and chroma (Y, RY, BY): save it with R, G and B");let n=t.length>12?` and ${t.length-12} more`:"";throw new G(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${n}`)}function Ul(r,e,t){let n=r.type?r.type.startsWith("deep"):(t&Nl)!==0,s=r.type?r.type==="tiledimage":(t&Il)!==0,i=o=>{throw new G(o)};n&&i("is a deep image, with any number of samples a pixel: flatten it"),r.envmap&&i("is a cube map: convert it to latitude and longitude"),r.channels.some(({x:o,y:c})=>o!==1||c!==1)&&i("has channels of fewer texels than others: save them all at full size"),cr[r.compression]===void 0&&i(`has compression ${r.compression}, expected one of ${cr.join(", ")}`),s&&e>1&&i("has tiles in one of several parts: save it with scan lines"),s&&r.levels===Pl&&i("has tiles of several sizes by row and column: save it with one size")}function Dl(r){let e=_s(r),t=new Set;for(let{name:n,type:s}of r.channels)e.includes(n)&&t.add(["uint32","float16","float32"][s]);if(t.size>1||t.has("uint32"))throw new G(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function Hl(r,e){let t=r.slice(),n=_s(e),s=e.channels.find(({name:o})=>o===n[0]).type,i=["DWAA","DWAB"].includes(cr[e.compression]);for(let o of e.channels)if(o.type===Ml&&cr[e.compression]!=="PXR24"&&(t[o.typeAt]=Ll),["A","Y","RY","BY"].includes(o.name)&&!n.includes(o.name)&&!(i&&o.type===s))for(let l=0;l<o.name.length;l++)t[o.at+l]|=32;return t}function Bl(r){let e=new DataView(r.buffer,r.byteOffset,r.length),t=e.getUint32(4,!0),n={bytes:r,view:e,at:8},s=[];do{let i=$l(n);if(i===null)break;s.push(i)}while(t&Ol);if(!s.length)throw new G("broken EXR image: it has no header");return{parts:s,flags:t}}function $l(r){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=r;for(let s=0;;s++){let i=gs(r);if(i===""){if(s===0)return null;break}let o=gs(r),c=t.getInt32(r.at,!0),l=r.at+4;if(c<0||l+c>r.bytes.length||s>Fl)throw new G("broken EXR image: an attribute goes past the file's end");i==="channels"&&(e.channels=Gl({...r,at:l})),i==="compression"&&(e.compression=t.getUint8(l)),(i==="dataWindow"||i==="displayWindow")&&(e[i]=[0,4,8,12].map(f=>t.getInt32(l+f,!0))),i==="type"&&(e.type=String.fromCharCode(...r.bytes.subarray(l,l+Math.min(c,64)))),i==="envmap"&&o==="envmap"&&(e.envmap=t.getUint8(l)),i==="tiles"&&(e.levels=t.getUint8(l+8)&15),r.at=l+c}let n=["channels","compression","dataWindow","displayWindow"].find(s=>e[s]===null);if(n!==void 0)throw new G(`broken EXR image: it has no ${n}`);return e}function Gl(r){let e=[];for(;;){let t=r.at,n=gs(r);if(n==="")return e;let s=r.at,{view:i}=r;e.push({name:n,at:t,typeAt:s,type:i.getInt32(s,!0),x:i.getInt32(s+8,!0),y:i.getInt32(s+12,!0)}),r.at+=16}}function gs(r){let e=r.bytes.indexOf(0,r.at);if(e<0||e-r.at>255)throw new G("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(r.bytes.subarray(r.at,e));return r.at=e+1,t}var ql=65536,to=[8,32767],jl=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,Zl=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,vs=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,we=r=>new G(`broken HDR image${r}`);function no(r){let e=Yl(r),{count:t,length:n,columns:s,back:i,exposure:o}=e,c=Wl(r,e),l=1/o,[f,h]=s?[t,n]:[n,t],m=new Float32Array(3*f*h);for(let _=0;_<t;_++){let v=i[0]?t-1-_:_;for(let x=0;x<n;x++){let A=i[1]?n-1-x:x,N=4*(_*n+x),D=3*(s?A*f+v:v*f+A),q=c[N+3],X=q>0?l*2**(q-136):0;for(let Q=0;Q<3;Q++)m[D+Q]=c[N+Q]*X}}return{rgb:m,width:f,height:h}}function Yl(r){let e=[],t=0,n=-1;for(;n<0||e.length<n+2;){let m=r.subarray(0,ql).indexOf(10,t);if(m<0)throw we(": it has no header");e.push(Array.from(r.subarray(t,m),_=>String.fromCharCode(_)).join("")),t=m+1,n<0&&e.at(-1).replace(/\r+$/,"")===""&&(n=e.length-1)}let s=1;for(let m of e.slice(1,n)){let _=m.indexOf("="),[v,x]=_<0?[m,""]:[m.slice(0,_),m.slice(_+1)],A=v.replace(vs,""),N=x.replace(vs,"");if(A==="FORMAT"&&N!=="32-bit_rle_rgbe")throw we(`: format '${N}', expected 32-bit_rle_rgbe`);A==="EXPOSURE"&&(s*=Zl.test(N)?Number(N)||1:0)}if(!(s>0&&s<1/0))throw we(": EXPOSURE is not a positive number");let i=e[n+1].replace(vs,""),o=jl.exec(i);if(o===null||o[2]===o[5])throw we(`: size '${i.slice(0,40)}', expected such as '-Y height +X width'`);let c=Number(o[3]),l=Number(o[6]),f=o[2]==="X",h=[o[1]+o[2],o[4]+o[5]].map(m=>m==="+Y"||m==="-X");return or(...f?[c,l]:[l,c],r.length),{offset:t,count:c,length:l,columns:f,back:h,exposure:s}}function Wl(r,{offset:e,count:t,length:n}){let s=new Uint8Array(4*t*n),i=e;try{for(let o=0;o<t;o++)i=Vl(r,i,s.subarray(4*o*n),n,o)}catch(o){if(r.length-e===s.length)return r.subarray(e);throw o}return s}function Vl(r,e,t,n,s){if(n>=to[0]&&n<=to[1]&&e+4<=r.length&&r[e]===2&&r[e+1]===2&&r[e+2]<128){if(r[e+2]*256+r[e+3]!==n)throw we(`, line ${s}: a run goes past the line's end`);return Xl(r,e+4,t,n,s)}return Kl(r,e,t,n,s)}function Xl(r,e,t,n,s){for(let i=0;i<4;i++)for(let o=0;o<n;){if(e+2>r.length)throw we(`, line ${s}: the file ends there`);let c=r[e]>128,l=c?r[e]-128:r[e];if(l===0)throw we(`, line ${s}: a run of no pixels`);if(o+l>n)throw we(`, line ${s}: a run goes past the line's end`);if(e+1+(c?1:l)>r.length)throw we(`, line ${s}: the file ends there`);for(let f=0;f<l;f++)t[4*(o+f)+i]=r[e+1+(c?0:f)];o+=l,e+=c?2:1+l}return e}function Kl(r,e,t,n,s){let i=0,o=0;for(;i<n;){if(e+4>r.length)throw we(`, line ${s}: the file ends there`);if(r[e]===1&&r[e+1]===1&&r[e+2]===1){if(i===0)throw we(`, line ${s}: a run repeats a pixel, but there is none before it`);let c=o>16?1/0:r[e+3]*2**o;if(i+c>n)throw we(`, line ${s}: a run goes past the line's end`);for(let l=0;l<c;l++)t.copyWithin(4*(i+l),4*(i-1),4*i);i+=c,o+=8}else t.set(r.subarray(e,e+4),4*i),i+=1,o=0;e+=4}return e}var Jl=[118,47,49,1],Ql=[35,63];function ys(r,e){let t=new Uint8Array(r),n=i=>i.every((o,c)=>t[c]===o),s=n(Jl)?eo:n(Ql)?no:null;if(s===null)throw new G(`${e}: is ${Lt(t)??"neither an EXR nor a Radiance HDR image"}`);try{return eu(s(t))}catch(i){let o=i instanceof G?i.message:`cannot read the image: ${i.message??i}`;throw new G(`${e}: ${o}`)}}function eu(r){let{rgb:e}=r,t=0;for(let n=0;n<e.length;n+=3){let s=!0;for(let i=n;i<n+3;i++)s&&=Number.isFinite(e[i])&&e[i]<=Ji,e[i]>0||(e[i]=0);s||t++}if(t)throw new G(`has ${t} texels that are not finite numbers of at most 1e+18`);return r}function ro(r){return r.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var so={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var lr=so.blocks,_t=r=>lr.find(e=>e.name===r),ur=(r,e)=>_t(r).width??e;var rt=22,vt=46,dn=30,io=64,oo=256,nu=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,Dt="manifest.json",ao=2**20,_n=r=>new DataView(r.buffer,r.byteOffset,r.byteLength);async function lo(r){let{size:e}=r;e===0&&w("FILE_EMPTY",r.name,"the file has no bytes"),e>2**32-2&&w("FILE_TOO_LARGE",r.name,`${e} bytes`);let{count:t,start:n}=await ru(r),s=await r.read(n,e-rt),i=iu(s,t,n,r.name);return au(i,n,r.name),new Map(i.map(o=>[o.name,o]))}async function ru(r){let{size:e,name:t}=r,n=await r.read(0,Math.min(512,e)),s=Lt(n);s&&w("ZIP_NOT_ZIP",t,`expected a package, found ${s}`);let o=e>=4&&_n(n).getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<rt&&w(o,t,"shorter than the end record of a ZIP archive");let c=_n(await r.read(e-rt,e)),l=e===rt&&c.getUint32(0,!0)===101010256;c.getUint32(0,!0)!==101010256&&await su(r,o);let f=v=>c.getUint16(v,!0);[4,6,8,10].some(v=>f(v)===65535)&&w("ZIP_ZIP64",t,"a ZIP64 archive"),(f(4)||f(6))&&w("ZIP_ZIP64",t,"an archive of several disks");let h=f(10),m=c.getUint32(12,!0),_=c.getUint32(16,!0);return h>oo&&w("ZIP_TOO_MANY",t,`${h} entries; at most ${oo}`),(f(8)!==h||f(20)!==0||_+m!==e-rt)&&w("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(l||h===0)&&w("ZIP_ORDER",t,`${Dt} is not the first entry`),{count:h,start:_}}async function su(r,e){let t=await r.read(Math.max(0,r.size-rt-65535),r.size),n=_n(t);for(let s=t.length-rt;s>=0;s--)n.getUint32(s,!0)===101010256&&s+rt+n.getUint16(s+20,!0)===t.length&&w("ZIP_DIRECTORY",r.name,"the archive has a comment");w(e,r.name,"the file does not end with the end record of a ZIP archive")}function iu(r,e,t,n){let s=_n(r),i=[],o=new Set,c=0;for(let l=0;l<e;l++){(c+vt>r.length||s.getUint32(c,!0)!==33639248)&&w("ZIP_DIRECTORY",n,`the central directory has no header ${l}`);let f=s.getUint16(c+28,!0);(c+vt+f>r.length||s.getUint32(c+30,!0))&&w("ZIP_DIRECTORY",n,`header ${l} of the central directory is malformed`);let h=r.subarray(c+vt,c+vt+f),m=String.fromCharCode(...h);ou(s,c,m,n),(!nu.test(m)||m.includes(`
`)||f>200)&&w("ZIP_NAME",n,`an entry is called ${JSON.stringify(m.slice(0,80))}`);let _=m.toLowerCase();o.has(_)&&w("ZIP_DUPLICATE",m,"the name is there twice"),o.add(_),i.push({name:m,size:s.getUint32(c+24,!0),crc:s.getUint32(c+16,!0),header:s.getUint32(c+42,!0),central:r.subarray(c,c+vt+f)}),c+=vt+f}c!==r.length&&w("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:l,header:f,size:h}of i)f+dn+l.length+h>t&&w("ZIP_TRUNCATED",l,`${h} bytes reach past the entries`);return i}function ou(r,e,t,n){let s=l=>r.getUint16(e+l,!0),i=l=>r.getUint32(e+l,!0),o=JSON.stringify(t.slice(0,80));(i(42)===4294967295||i(20)===4294967295||i(24)===4294967295)&&w("ZIP_ZIP64",n,`${o} needs ZIP64`),s(34)&&w("ZIP_ZIP64",n,`${o} is on another disk`),s(8)&1&&w("ZIP_ENCRYPTED",n,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,f])=>s(l)!==f)||i(38))&&w("ZIP_HEADER",n,`${o}: a version, flag, time or attribute is not the fixed one`),s(10)&&w("ZIP_COMPRESSED",n,`${o} is compressed`),i(20)!==i(24)&&w("ZIP_SIZE",n,`${o} has two sizes`)}function au(r,e,t){let n=[...r].sort((o,c)=>o.header-c.header),s=0;n.forEach((o,c)=>{o.end=c+1<n.length?n[c+1].header:e,o.extra=o.end-o.header-dn-o.name.length-o.size,o.extra<0&&w("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==s&&w("ZIP_GAP",t,`bytes ${s} to ${o.header} are no entry's`),s=o.end});let i=n[0];i.name!==Dt&&w("ZIP_ORDER",t,`${Dt} is not the first entry`),i.size>ao&&w("MANIFEST_TOO_LARGE",Dt,`${i.size} bytes; at most ${ao}`)}function uo(r,e){let t=_n(e),{name:n}=r,s=r.name.length;e.length<r.end-r.header&&w("ZIP_TRUNCATED",n,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===s&&co(e.subarray(4,26),r.central.subarray(6,28))&&co(e.subarray(dn,dn+s),r.central.subarray(vt))||w("ZIP_LOCAL_HEADER",n,"local and central header differ");let o=t.getUint16(28,!0),c=dn+s;cu(e.subarray(c,c+o),o,n),(r.header+c+o)%io&&w("ZIP_ALIGNMENT",n,`data at byte ${r.header+c+o}, no multiple of ${io}`),o!==r.extra&&w(o>r.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let l=e.subarray(c+o,c+o+r.size);return lu(l)!==r.crc&&w("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),l}function cu(r,e,t){if(e===0)return;e>=4&&r.length===e&&r[0]===82&&r[1]===78&&r[2]+256*r[3]===e-4&&r.subarray(4).every(s=>s===0)||w("ZIP_EXTRA",t,"the extra field is not zero padding")}var co=(r,e)=>r.length===e.length&&r.every((t,n)=>t===e[n]),gn=Array.from({length:4},()=>new Uint32Array(256));for(let r=0;r<256;r++){let e=r;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;gn[0][r]=e>>>0}for(let r=1;r<4;r++)for(let e=0;e<256;e++){let t=gn[r-1][e];gn[r][e]=t>>>8^gn[0][t&255]}function lu(r){let[e,t,n,s]=gn,i=4294967295,o=0;for(;o+4<=r.length;o+=4)i^=r[o]|r[o+1]<<8|r[o+2]<<16|r[o+3]<<24,i=s[i&255]^n[i>>>8&255]^t[i>>>16&255]^e[i>>>24];for(;o<r.length;o++)i=e[(i^r[o])&255]^i>>>8;return(i^4294967295)>>>0}var uu=64,fu=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,hu=/[ \t\n\r]*/y,pu=/[^"\\\u0000-\u001f]*/y,fo={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function Ht(r,e,t){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{w(t,e,"no UTF-8")}let s=new ws(n,e,t);s.space(),n[s.at]!=="{"&&w(t,e,"not a JSON object");let i=s.value(1);return s.space(),s.at!==n.length&&s.bad(),i}var ws=class{constructor(e,t,n){Object.assign(this,{text:e,where:t,code:n,at:0})}bad(e="malformed JSON"){w(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(hu)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>uu&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[i,o]of[["true",!0],["false",!1],["null",null]])if(this.take(i))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(fu);n||this.bad();let s=Number(n[0]);return Number.isFinite(s)||this.notFinite(),s===0?0:s}notFinite(){w("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let s=this.string();t.has(s)&&w("JSON_DUPLICATE_KEY",this.where,`the key "${s}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(s,this.value(e+1))});let n=Object.create(null);for(let[s,i]of t)n[s]=i;return n}string(){let e="";for(this.at+=1;e+=this.match(pu)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),e+=String.fromCharCode(parseInt(n[0],16))}else t in fo?e+=fo[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var ho={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},mu=65536;function Bt(r,e,t,n){let s=e.byteOffset+t;return s%r.BYTES_PER_ELEMENT===0?new r(e.buffer,s,n):new r(e.slice(t,t+n*r.BYTES_PER_ELEMENT).buffer)}function st(r,e,t){r.length<8&&w(t,e,"shorter than a header");let n=new DataView(r.buffer,r.byteOffset).getBigUint64(0,!0);(n>mu||Number(n)>r.length-8)&&w(t,e,`a header of ${n} bytes`);let s=8+Number(n);r[8]!==123&&w(t,e,"the header does not start with {");let{__metadata__:i,...o}=Ht(r.subarray(8,s),e,t);return{tensors:o,metadata:i,data:s}}var mo=r=>r!==null&&typeof r=="object"&&!Array.isArray(r),po=r=>Number.isSafeInteger(r)&&r>=0;function it(r){return mo(r)&&typeof r.dtype=="string"&&Array.isArray(r.shape)&&r.shape.every(po)&&Array.isArray(r.data_offsets)&&r.data_offsets.length===2&&r.data_offsets.every(po)}var ot=r=>r===void 0||mo(r);function at(r,{tensors:e,data:t},n,s,i){let o=0,c=n.map(l=>{let{dtype:f,shape:h,data_offsets:[m,_]}=e[l],v=h.reduce((x,A)=>x*A,1);return(m!==o||_-m!==v*ho[f].BYTES_PER_ELEMENT||t+_>r.length)&&w(i,s,`the bytes of ${l} are not where they must be`),o=_,Bt(ho[f],r,t+m,v)});return t+o!==r.length&&w(i,s,"bytes behind the last tensor"),c}var go=2**26,du=2**25,gu=2**31,_u={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},vu={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function _o(r,e){let t=st(r,e,"GEOMETRY_CONTAINER"),{tensors:n}=t,s="steps"in n||"scales"in n,i=s?vu:_u,o=Object.keys(i);yu(t,i,o,e);let c=Object.fromEntries(o.map(x=>[x,n[x].shape])),l=at(r,t,o,e,"GEOMETRY_RANGE"),f=Object.fromEntries(o.map((x,A)=>[x,l[A]])),h=c.offsets[0]-1,m=c.radii[0];(!(s?c.origins[0]===h&&c.steps[0]===m-h&&c.scales[0]===2:c.points[0]===m)||h<1)&&w("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),wu(f.offsets,m,e);let v=s?xu(f,e):f;return bu(v,e),v}function yu(r,e,t,n){let{tensors:s}=r,i="GEOMETRY_PROFILE",o=Object.keys(s);(o.length!==t.length||t.some(l=>!o.includes(l)))&&w(i,n,`found ${o.join(", ")||"no tensors"}, expected ${t.join(", ")}`),ot(r.metadata)||w(i,n,"__metadata__ is no object");for(let[l,[f,h]]of Object.entries(e)){let m=s[l];it(m)&&f.includes(m.dtype)&&m.shape.length===h&&(h===1||m.shape[1]===3)||w(i,n,`${l} is not ${f.join(" or ")} of ${h} dimensions`)}((s.points??s.radii).shape[0]>go||s.radii.shape[0]>go||s.offsets.shape[0]-1>du)&&w(i,n,"more points or strands than allowed"),r.data%64&&w(i,n,"data does not start at a multiple of 64")}function wu(r,e,t){let n=r[0]===0&&r.at(-1)===e;for(let s=1;s<r.length&&n;s++)n=r[s]>=r[s-1]+2;n||w("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function xu({scales:r,origins:e,offsets:t,steps:n,radii:s},i){let[o,c]=r;o>0&&Number.isFinite(o)||w("GEOMETRY_STEPS",i,"steps without length"),e.some(h=>!Number.isFinite(h))&&w("GEOMETRY_NOT_FINITE",i,"an origin is not finite"),(!(c>0&&Number.isFinite(c))||s.some(h=>h===0))&&w("GEOMETRY_RADIUS",i,"a radius that is not above 0");let l=new Float32Array(3*s.length),f=0;for(let h=0;h+1<t.length;h++){for(let m=0;m<3;m++){let _=e[3*h+m],v=0;l[3*t[h]+m]=_;for(let x=t[h]+1,A=f;x<t[h+1];x++,A++)v+=n[3*A+m],Math.abs(v)>gu&&w("GEOMETRY_STEPS",i,`strand ${h} goes too far`),l[3*x+m]=_+o*v}f+=t[h+1]-t[h]-1}return{points:l,radii:Float32Array.from(s,h=>h*c),offsets:t}}function bu({points:r,radii:e,offsets:t},n){(r.some(s=>!Number.isFinite(s))||e.some(s=>!Number.isFinite(s)))&&w("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let s=0;s+1<t.length;s++)for(let i=t[s]+1;i<t[s+1];i++)r[3*i]===r[3*i-3]&&r[3*i+1]===r[3*i-2]&&r[3*i+2]===r[3*i-1]&&w("GEOMETRY_SEGMENT",n,`two equal points in strand ${s}`);e.some(s=>!(s>0))&&w("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var xs=[0,1,-1,1e4,-1e4,34028234663852886e22,-34e37],Au=5,Eu=34028234663852886e22;function vo(r,e){let t=1,n=()=>(t=Math.imul(t,1664525)+1013904223|0)/2**31;for(let s=0;s<xs.length+Au;s++){let i=Float32Array.from({length:r.columns},()=>xs[s]??n()),o=Ru(r,i).find(c=>!(c>=0&&c<=Eu));o!==void 0&&w("DECODER_RESULT",e,`a query of ${xs[s]??"random"} numbers gives ${o}, expected finite results, not negative`)}}function Ru({low:r,high:e,gain:t,offset:n,layers:s,top:i,unit:o,matrix:c,outputs:l},f){let h=f.map(v=>Math.min(Math.max(v,r),e)),m=t?h.map((v,x)=>v*t[x]+n[x]):h;for(let v of s)m=ku(v,m);let _=m.map(v=>(Math.exp(Math.min(Math.max(v,0),i))-1)*o);return c?yo(_,c,l):_}function ku({weight:r,bias:e,columns:t,step:n,scales:s,relu:i},o){let c=s?o.map(l=>l/n>0?Su(Math.min(l/n,255)):0):o;return yo(c,r,t).map((l,f)=>{let h=s?(l+e[f])*n*s[f]:l+e[f];return i?Math.max(h,0):h})}var Su=r=>r+1.5*2**52-1.5*2**52;function yo(r,e,t){let n=new Float64Array(t);return r.forEach((s,i)=>{if(s!==0)for(let o=0,c=i*t;o<t;o++,c++)n[o]+=s*e[c]}),Float32Array.from(n)}var Te=1,As=2,Es=3,Rs=6,Tu={[Te]:Float32Array,[As]:Uint8Array,[Es]:Int8Array,[Rs]:Int32Array},wo=[3,4,5,6,7,10,11,13],xo=2**18;function Ao(r,{columns:e,outputs:t,output:n},s){let i=new bs(s),o=i.message(r,{1:"number",7:"bytes",8:"many",20:"many",25:"many"}),c=o[8].map(f=>i.message(f,{1:"text",2:"number"})),l=i.message(o[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});return o[1]>=7&&o[1]<=10||s(`IR version ${o[1]}, expected 7 to 10`),(c.length!==1||!Eo(c[0][1])||!(c[0][2]>=13&&c[0][2]<=21))&&s("operators that are not those of ONNX, version 13 to 21"),(o[20].length||o[25].length||l[15].length)&&s("functions, training or sparse tensors"),bo(i,l[11],"queries",e),bo(i,l[12],n,t),{nodes:l[1].map(f=>Iu(i,f)),constants:l[5].map(f=>Nu(i,f))}}var Eo=r=>r===""||r==="ai.onnx";function bo(r,e,t,n){let[s]=e.map(l=>r.message(l,{1:"text",2:"bytes"})),i=s&&r.message(r.message(s[2],{1:"bytes"})[1],{1:"number",2:"bytes"}),o=i&&r.message(i[2],{1:"many"})[1].map(l=>r.message(l,{1:"number?",2:"text"})[1]);e.length===1&&s[1]===t&&i[1]===Te&&o.length===2&&o[0]===void 0&&o[1]===n||r.outside(`not one ${t}, float32 [N, ${n}]`)}function Iu(r,e){let t=r.message(e,{1:"many",2:"many",4:"text",5:"many",7:"text"});(!Eo(t[7])||t[2].length!==1)&&r.outside(`${t[4]} of another domain, or of several results`);let n=t[5].map(s=>r.message(s,{1:"text",3:"number?"}));return(n.some(({1:s,3:i})=>s!=="axis"||i===void 0)||n.length>1)&&r.outside(`${t[4]} with another attribute than axis`),{operator:t[4],inputs:t[1].map(r.text),output:r.text(t[2][0]),axis:n[0]?.[3]??null}}function Nu(r,e){let t=Object.fromEntries(wo.map(h=>[h,"many"])),n=r.message(e,{1:"numbers",2:"number",8:"text",9:"bytes",14:"number",...t});(n[14]||wo.some(h=>n[h].length))&&r.outside("a constant not in raw_data");let{1:s,2:i,9:o}=n,c=Tu[i],l=s.reduce((h,m)=>h*m,1),f=c&&s.length<=2&&o.length===l*c.BYTES_PER_ELEMENT;return{name:n[8],type:i,dims:s,values:f?Bt(c,o,0,l):null}}var bs=class{constructor(e){this.outside=e,this.fields=0,this.text=t=>{try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){let n=Object.fromEntries(Object.keys(t).map(s=>[s,[]]));for(let s=0;s<e.length;){++this.fields>xo&&this.outside("too many fields");let i,o;[i,s]=this.varint(e,s),[o,s]=this.value(e,s,i%8),n[Math.floor(i/8)]?.push(o)}return Object.fromEntries(Object.entries(t).map(([s,i])=>[s,this.taken(n[s],i)]))}taken(e,t){if(t==="numbers")return e.flatMap(s=>typeof s=="number"?s:this.packed(s));let n=t.startsWith("number");return e.some(s=>typeof s=="number"!==n)&&this.outside("a field of another type"),t==="many"?e:(e.length>1&&this.outside("a field twice"),n?e[0]??(t==="number"?0:void 0):t==="text"?this.text(e[0]??new Uint8Array):e[0]??new Uint8Array)}packed(e){let t=[];for(let n=0,s;n<e.length;)++this.fields>xo&&this.outside("too many numbers"),[s,n]=this.varint(e,n),t.push(s);return t}value(e,t,n){if(n===0)return this.varint(e,t);let s={1:8,5:4}[n];return n===2&&([s,t]=this.varint(e,t)),(s===void 0||t+s>e.length)&&this.outside("a field that is cut short"),[e.subarray(t,t+s),t+s]}varint(e,t){for(let n=0,s=1,i=0;i<10&&t<e.length;i++,s*=128){let o=e[t++];if(n+=(o&127)*s,o<128)return[n,t]}return this.outside("a number that is cut short")}};var Ro=64*2**20,ko=4096,So=8192,To=2**16,Io=2**24,ct=[Te,[]],No=[As,[]];function Oo(r,{columns:e,outputs:t,output:n,precision:s},i){r.length>Ro&&w("DECODER_TOO_LARGE",i,`${r.length} bytes; at most ${Ro}`);let o=f=>w("DECODER_PROFILE",i,`not a decoder as the format has it: ${f}`),c=Ao(r,{columns:e,outputs:t,output:n},o),l=new ks(c,{columns:e,outputs:t,output:n,int8:s==="int8"},i,o).decoder();return vo(l,i),l}var ks=class{constructor({nodes:e,constants:t},n,s,i){Object.assign(this,n,{where:s,outside:i,width:n.columns,value:"queries",values:n.outputs,work:0}),e.length>ko&&i(`${e.length} nodes; at most ${ko}`);let o=["queries",...t.map(({name:c})=>c),...e.map(({output:c})=>c)];(new Set(o).size!==o.length||o.includes(""))&&i("a value made twice, or without a name"),this.constants=new Map(t.map(c=>[c.name,c])),this.unread=new Set(this.constants.keys()),this.dequantizers=new Map,this.nodes=e.values(),this.advance()}advance(){for(;;){if(this.node=this.nodes.next().value,this.node?.operator!=="DequantizeLinear"||!this.constants.has(this.node.inputs[0]))return;this.dequantizers.set(this.node.output,this.node)}}get operator(){return this.node?.operator??"nothing"}next(e,t){let{node:n}=this;return this.operator!==e&&this.outside(`${this.operator} where ${e} must be`),(n.inputs[0]!==this.value||n.inputs.length!==t+1||n.axis!==null)&&this.outside(`${e} of ${n.inputs.join(", ")}, not of ${this.value} and ${t} constants`),this.value=n.output,this.advance(),n.inputs.slice(1)}read(e,t){return e.length!==t.length&&this.outside(`${e.length} constants where ${t.length} must be`),t.map(([n,s],i)=>{let{values:o,...c}=this.constants.get(e[i])??{};return(!o||c.type!==n||c.dims.join()!==s.join())&&this.outside(`${e[i]} is no constant of type ${n} and shape [${s}]`),n===Te&&!o.every(Number.isFinite)&&w("DECODER_RESULT",this.where,`${e[i]} has values that are NaN or infinite`),this.unread.delete(e[i]),o})}take(e,...t){return this.read(this.next(e,t.length),t)}multiply(e,{isLayer:t}){let n=this.constants.get(e)?.dims[1]??0,s=this.width;return n>=1&&n<=So||this.outside(`${e} has ${n} columns; from 1 to ${So}`),t&&(this.values+=n),this.work+=s*n,(this.values>To||this.work>Io)&&w("DECODER_COST",this.where,`${this.values} values and ${this.work} multiply-adds of a query, or more; at most ${To} and ${Io}`),this.width=n,{rows:s,columns:n}}decoder(){let e=[Te,[this.columns]],{int8:t,columns:n,outputs:s}=this,[[i],[o]]=this.take("Clip",ct,ct),[c]=t?this.take("Mul",e):[null],[l]=t?this.take("Add",e):[null],f=[];do f.push(t?this.int8Layer():this.layer());while(t?this.operator!=="Clip":f.at(-1).relu);let[[h],[m]]=this.take("Clip",ct,ct);this.take("Exp");let[[_]]=this.take("Sub",ct);(h!==0||_!==1)&&this.outside(`Clip from ${h}, Sub of ${_}`);let v=this.operator==="MatMul"?this.mixing():{unit:this.take("Mul",ct)[0][0],matrix:null};return(this.node||this.dequantizers.size||this.unread.size)&&this.outside("a node or a constant that the chain does not have"),(this.value!==this.output||this.width!==s)&&this.outside(`${this.width} columns of ${this.value} in the end`),{low:i,high:o,gain:c,offset:l,layers:f,top:m,...v,int8:t,columns:n,outputs:s}}mixing(){let e=this.next("MatMul",1),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!1});return{unit:1,matrix:this.read(e,[[Te,[t,n]]])[0]}}layer(){let e=this.next("Gemm",2),{rows:t,columns:n}=this.multiply(e[0],{isLayer:!0}),[s,i]=this.read(e,[[Te,[t,n]],[Te,[n]]]),o=this.operator==="Relu";return o&&this.take("Relu"),{weight:s,bias:i,rows:t,columns:n,relu:o}}int8Layer(){let[[e],[t]]=this.take("QuantizeLinear",ct,No),[[n],[s]]=this.take("DequantizeLinear",ct,No);(t||s||e!==n)&&this.outside("two scales, or a zero point");let i=new Map(this.dequantizers),[o,c]=this.next("Gemm",2).map((x,A)=>this.dequantized(i,x,1-A)),{rows:l,columns:f}=this.multiply(o[0],{isLayer:!0}),[h,m]=this.read(o,[[Es,[l,f]],[Te,[f]]]),[_,v]=this.read(c,[[Rs,[f]],[Te,[f]]]);return v.some((x,A)=>x!==Math.fround(e*m[A]))&&this.outside("a bias with a scale of its own"),{weight:h,bias:_,rows:l,columns:f,step:e,scales:m,relu:!1}}dequantized(e,t,n){let s=e.get(t);return(s?.axis!==n||!this.dequantizers.delete(t))&&this.outside(`${t} is no DequantizeLinear of constants along axis ${n}`),s.inputs}};async function Mo(r,{elementSize:e,distance:t,size:n},s){let i=await Ou(r,n,s),o=Math.floor(n/e),c=new Uint8Array(n);for(let l=0;l<e;l++){let f=l*o;for(let h=0;h<o;h++)c[h*e+l]=i[f+h]}if(c.set(i.subarray(o*e),o*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],f=new l(c.buffer,0,o);for(let h=t;h<o;h++)f[h]+=f[h-t]}return c}async function Ou(r,e,t){let n=new Uint8Array(e),s=0;try{let i=new Blob([r]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:c}=await i.read();if(o)break;if(s+c.length>e)throw i.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);n.set(c,s),s+=c.length}}catch(i){w("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${i.message})`)}return s!==e&&w("DEFLATE_STREAM",t,`inflates to ${s} bytes, expected ${e}`),n}var $t={$schema:"https://json-schema.org/draft/2020-12/schema",title:"Manifest",$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}},additionalProperties:!1,description:"manifest.json. `write_package` computes `entries`; leave them out.",properties:{format:{const:"rna",type:"string"},version:{const:"2.0",description:"Version of the format.",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"}},required:["format","version","units","entries","generator","name","parts","domain","tiers","provenance","license"],type:"object"};var Gt=16,Lu=32,{emission:im,...Lo}=$t.$defs.TierPart.properties,Po={$defs:$t.$defs,type:"object",required:["parts"],additionalProperties:!1,properties:{parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"object",additionalProperties:!1,required:[...$t.$defs.TierPart.required,"lobes"],properties:{...Lo,lobes:{type:"integer",minimum:2,maximum:Lu},visibility:Lo.planes}}]}},validation:{type:"array",maxItems:64}}};function Fo(r){let e=r.extensions?.RNA_environment?.parts;return e?.every(t=>t)?e:null}function Co({parts:r},e,t){r.some(n=>n)||w("FIELD_VALUE",t,"lobes of no part"),r.forEach((n,s)=>{if(!n)return;let i=`${t}/parts/${s}`;n.lobes%2&&w("FIELD_VALUE",`${i}/lobes`,`found ${n.lobes}, expected an even number`);for(let o of n.inputs)_t(o).kinds.includes(e.parts[s].kind)||w("INPUT_KIND",`${i}/inputs`,`${o} is not for this part`);for(let o of fr([n]))Object.hasOwn(e.entries,o)||w("REFERENCE_MISSING",i,`no entry ${o}`)})}var fr=r=>r.flatMap(({planes:e,decoder:t,visibility:n})=>[e,t,...n?[n]:[]]);function zo(r,e,t){let n="ENVIRONMENT_VISIBILITY",s=st(r,t,n),i=s.tensors.harmonics;ot(s.metadata)||w(n,t,"__metadata__ is no object"),(Object.keys(s.tensors).join()!=="harmonics"||!it(i))&&w(n,t,"not one tensor harmonics");let o=[e,Gt];return(i.dtype!=="I8"||i.shape.join()!==o.join())&&w(n,t,`found ${i.dtype} [${i.shape}], expected I8 [${o}]`),s.data%64&&w(n,t,"data does not start at a multiple of 64"),at(r,s,["harmonics"],t,n)[0]}var Ss={object:r=>r!==null&&typeof r=="object"&&!Array.isArray(r),array:Array.isArray,string:r=>typeof r=="string",number:r=>typeof r=="number",integer:r=>Number.isSafeInteger(r),boolean:r=>typeof r=="boolean",null:r=>r===null};function qt(r,e,t=""){new Is(r).check(r,e,t)}var Is=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,n){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,n);let s=i=>w("FIELD_VALUE",n,`found ${Ts(t)}, expected ${i}`);e.type&&!Ss[e.type](t)&&s(e.type),"const"in e&&t!==e.const&&s(Ts(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&w("INPUT_UNKNOWN",n,`no block ${Ts(t)}`),s(e.enum.join(", ")));for(let i of[e.anyOf,e.oneOf])i&&!i.some(o=>this.fits(o,t))&&this.check(i.find(o=>Ss[o.type]?.(t))??i[0],t,n);e.not&&this.fits(e.not,t)&&s("another value"),typeof t=="number"&&this.checkNumber(e,t,s),typeof t=="string"&&this.checkString(e,t,s),Array.isArray(t)?this.checkArray(e,t,n,s):Ss.object(t)&&this.checkObject(e,t,n)}checkNumber(e,t,n){t<e.minimum&&n(`at least ${e.minimum}`),t>e.maximum&&n(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&n(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&n(`less than ${e.exclusiveMaximum}`)}checkString(e,t,n){t.length<e.minLength&&n(`${e.minLength} characters or more`),t.length>e.maxLength&&n(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&n(e.pattern)}checkArray(e,t,n,s){t.length<e.minItems&&s(`${e.minItems} items or more`),t.length>e.maxItems&&s(`at most ${e.maxItems} items`),t.forEach((i,o)=>{let c=e.prefixItems?.[o]??e.items;c&&this.check(c,i,`${n}/${o}`)}),e.uniqueItems&&new Set(t).size!==t.length&&w("INPUT_UNKNOWN",n,"a name twice")}checkObject(e,t,n){let s=Object.keys(t),i=e.properties??{};for(let o of s)e.additionalProperties===!1&&!Object.hasOwn(i,o)&&w("FIELD_UNKNOWN",`${n}/${o}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},o,`${n}/${o}`);for(let o of e.required??[])Object.hasOwn(t,o)||w("FIELD_MISSING",`${n}/${o}`,"missing");for(let o of s){let c=Object.hasOwn(i,o)?i[o]:e.additionalProperties;c&&this.check(c,t[o],`${n}/${o}`)}}};function Ts(r){let e=JSON.stringify(r);return e.length>60?`${e.slice(0,57)}...`:e}var Ns={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},vn=(r,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:r,maximum:e}),Os={type:"number",minimum:0,maximum:1},yt=r=>({type:"object",properties:r,required:Object.keys(r),additionalProperties:!1}),Uo=2**32-2,Pu=2**20,Fu=64,Do={RNA_deflate:yt({entries:{type:"object",propertyNames:Ns,additionalProperties:yt({elementSize:{enum:[1,2,4]},distance:vn(0),size:vn(0,Uo),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:yt({image:Ns,width:vn(1),height:vn(1)}),RNA_standin:yt({parts:{type:"array",minItems:1,maxItems:16,items:yt({baseColor:{type:"array",items:Os,minItems:3,maxItems:3},roughness:Os,metallic:Os})}}),RNA_proxy:yt({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:yt({geometry:Ns,height:vn(1)})}]}}}),RNA_environment:Po},hr=Object.keys(Do);function Ho(r){let e=r.extensions??{};for(let t of hr){let n=`/extensions/${t}`;if(!Object.hasOwn(e,t)){r.extensionsUsed?.includes(t)&&w("FIELD_MISSING",n,"its data is missing");continue}qt(Do[t],e[t],n),Cu[t](e[t],r,n)}}function Ms(r,e,t){Object.hasOwn(r.entries,e)||w("REFERENCE_MISSING",t,`no entry ${e}`)}function Ls(r,e,t){r.length!==e.parts.length&&w("PARTS_DIFFER",t,`found ${r.length} parts, expected ${e.parts.length}`)}var Cu={RNA_deflate({entries:r},e,t){e.extensionsRequired?.includes("RNA_deflate")||w("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let n=Object.values(r).reduce((s,{size:i})=>s+i,0);n>Uo&&w("FIELD_VALUE",t,`${n} decoded bytes`);for(let[s,{size:i}]of Object.entries(r)){Ms(e,s,t);let o=Pu+Fu*e.entries[s].size;i>o&&w("DEFLATE_SIZE",`${t}/entries/${s}/size`,`${i} decoded bytes; at most ${o}`)}},RNA_poster({image:r},e,t){Ms(e,r,t)},RNA_standin({parts:r},e,t){Ls(r,e,t)},RNA_proxy({parts:r},e,t){Ls(r,e,t),r.some(n=>n)||w("FIELD_VALUE",t,"a proxy of no part"),r.forEach((n,s)=>{let{transmittance:i,normalMaps:o}=e.parts[s];n&&(i||o)&&w("FIELD_VALUE",t,"a proxy of a part with textures"),(n??[]).forEach(({geometry:c,height:l},f)=>{Ms(e,c,t),f&&l>=n[f-1].height&&w("FIELD_VALUE",t,"heights must descend")})})},RNA_environment(r,e,t){Ls(r.parts,e,t),Co(r,e,t)}};var Ps="2.0",zu=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function Bo(r){let e=Ht(r,"manifest.json","MANIFEST_NOT_JSON");Uu(e),qt($t,e),Du(e),Hu(e),Bu(e),$u(e),Ho(e),Gu(e),qu(e),Zu(e);let t=(e.extensionsUsed??[]).filter(n=>!hr.includes(n));return{...e,warnings:t.map(n=>`unknown extension ${n}`)}}function Uu(r){"format"in r||w("FIELD_MISSING","/format","missing"),r.format!=="rna"&&w("FORMAT_UNKNOWN","/format","this is no RNA package");let{version:e}=r;if(typeof e=="string"&&zu.test(e)&&e!==Ps){let t=parseInt(e,10)<parseInt(Ps,10)?"VERSION_TOO_OLD":"VERSION_TOO_NEW";w(t,"/version",`the package is of version ${e}; this viewer reads ${Ps}`)}for(let t of Array.isArray(r.parts)?r.parts:[])t?.kind!==void 0&&!["surface","fiber"].includes(t.kind)&&w("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(t.kind)}, expected surface or fiber`);for(let t of Array.isArray(r.extensionsRequired)?r.extensionsRequired:[])typeof t=="string"&&!hr.includes(t)&&w("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${t}`)}function Du(r){r.parts.forEach(({bounds:{min:e,max:t}},n)=>{e.forEach((s,i)=>{Math.fround(t[i])-Math.fround(s)>=1e-18||w("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${i}`)})});for(let e of["wo","wi"]){let t=r.domain[e];for(let{axis:n}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...n)-1)>.001&&w("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function Hu(r){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=r[e].map(({name:s})=>s);new Set(n).size!==n.length&&w(t,`/${e}`,"a name is there twice")}r.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:n},s,i)=>{s&&n>=i[s-1].height&&w("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${s}`,"heights must descend")})})}function Bu(r){r.tiers.forEach((e,t)=>{e.parts.length!==r.parts.length&&w("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${r.parts.length}`),e.parts.forEach((n,s)=>{!n.emission!=!r.tiers[0].parts[s].emission&&w("PARTS_DIFFER",`/tiers/${t}/parts/${s}`,"emission in some tiers alone")})})}function $u(r){let e=r.extensionsUsed??[];for(let t of[...Object.keys(r.extensions??{}),...r.extensionsRequired??[]])e.includes(t)||w("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function Gu(r){r.tiers.forEach((e,t)=>e.parts.forEach((n,s)=>{let{kind:i}=r.parts[s],o=(c,l)=>{for(let f of c)l(_t(f))||w("INPUT_KIND",`/tiers/${t}/parts/${s}/inputs`,`${f} is not for this part`)};o(n.inputs,({kinds:c})=>c.includes(i)),o(n.emission?.inputs??[],({kinds:c,light:l})=>c.includes(i)&&!l)}))}function qu(r){r.parts.forEach((e,t)=>{for(let[n,s]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let i=`/parts/${t}/${n}`;e[n]&&e.kind!=="surface"&&w("FIELD_VALUE",i,`of a ${e.kind}`);let o=0;(e[n]??[]).forEach(({triangles:[c,l]},f)=>{c<o&&w(s,`${i}/${f}`,"ranges must ascend and not overlap"),o=c+l})}})}function*ju(r){for(let[e,t]of r.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let n of["transmittance","normalMaps"])for(let[s,i]of(t[n]??[]).entries())yield[`/parts/${e}/${n}/${s}`,i.texture]}for(let[e,t]of r.tiers.entries())for(let[n,s]of t.parts.entries()){let i=`/tiers/${e}/parts/${n}`;yield[`${i}/planes`,s.planes],yield[`${i}/decoder`,s.decoder],s.emission&&(yield[`${i}/emission/decoder`,s.emission.decoder])}}function Zu(r){let e=new Set;for(let[n,s]of ju(r))Object.hasOwn(r.entries,s)||w("REFERENCE_MISSING",n,`no entry ${s}`),e.add(s);let t=(r.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(r.entries))!e.has(n)&&!t.some(s=>n.startsWith(s))&&w("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function $o(r,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(r.entries,t)&&w("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:n}]of Object.entries(r.entries)){let s=e.get(t);(!s||t==="manifest.json")&&w("ENTRY_MISSING","/entries",`the archive lacks ${t}`),s.size!==n&&w("ENTRY_SIZE",`/entries/${t}`,`found ${s.size}, expected ${n}`)}}var lt={type:"string"},Go={type:"array",items:{type:"number"}},Pe=r=>({type:"integer",minimum:r,maximum:2**32-1}),ut=r=>({type:"array",minItems:1,maxItems:1,items:r}),Fe=(r,e={})=>({type:"object",properties:{...r,...e},required:Object.keys(r),additionalProperties:!1}),qo={type:"array",minItems:3,maxItems:3,items:{type:"number"}},jo={const:"KHR_mesh_quantization"};function Zo(r){let e=r?[5122,5123,5125,5126]:[5125,5126],t=Fe({bufferView:Pe(0),componentType:{enum:e},count:Pe(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Pe(0),normalized:r?{type:"boolean"}:{const:!1},min:Go,max:Go,name:lt}),n=Fe({buffer:{const:0},byteLength:Pe(1)},{byteOffset:Pe(0),target:{enum:[34962,34963]},name:lt,...r&&{byteStride:{enum:[4,8]}}}),s=Fe({POSITION:Pe(0),NORMAL:Pe(0)},{TEXCOORD_0:Pe(0)}),i=Fe({attributes:s,indices:Pe(0)},{mode:{const:4}});return Fe({asset:Fe({version:{const:"2.0"}},{generator:lt,copyright:lt}),scenes:ut(Fe({nodes:ut({const:0})},{name:lt})),nodes:ut(Fe({mesh:{const:0},...r&&{translation:qo,scale:qo}},{name:lt})),meshes:ut(Fe({primitives:ut(i)},{name:lt})),buffers:ut(Fe({byteLength:Pe(1)},{name:lt})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...r&&{extensionsUsed:ut(jo),extensionsRequired:ut(jo)}},{scene:{const:0},extras:{}})}var Yu=Zo(!1),Wu=Zo(!0);function Yo(r,e){let t="extensionsUsed"in r||"extensionsRequired"in r;try{qt(t?Wu:Yu,r)}catch(n){w("GEOMETRY_PROFILE",e,`${n.where}: not as meshes of packages are`)}return t&&Vu(r.nodes[0],e),Xu(r,t,e),t}function Vu({scale:[r,e,t]},n){r>0&&r===e&&r===t||w("GEOMETRY_PROFILE",n,`the scale ${[r,e,t]}`)}function Xu(r,e,t){let{attributes:n,indices:s}=r.meshes[0].primitives[0],i=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[c,l]of[...Object.entries(n),["indices",s]]){let f=r.accessors[l],h=f&&r.bufferViews[f.bufferView];if(!h)continue;let[m,_]=i[c];m.includes(f.type)&&_.some(([x,A,N])=>f.componentType===x&&(f.normalized??!1)===A&&h.byteStride===N)||w("GEOMETRY_PROFILE",t,`the accessor of ${c}`)}r.accessors[s]?.componentType===5123&&r.accessors[n.POSITION]?.count>=65535&&w("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var Ku={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},Ju={SCALAR:1,VEC2:2,VEC3:3};function Wo(r,e){let{json:t,bin:n}=Qu(r,e),s=Yo(t,e),i=t.buffers[0].byteLength;(i>n.length||n.length-i>3)&&w("GEOMETRY_RANGE",e,`a buffer of ${i} bytes in a chunk of ${n.length}`);let o=t.meshes[0].primitives[0],c=h=>ef(t,n.subarray(0,i),h,e),l={positions:c(o.attributes.POSITION),normals:c(o.attributes.NORMAL),uvs:"TEXCOORD_0"in o.attributes?c(o.attributes.TEXCOORD_0):null,indices:c(o.indices)};tf(l,e),nf(t.accessors[o.attributes.POSITION],l.positions,s,e);let f=s?rf(l,t.nodes[0]):l;return f.indices=Uint32Array.from(l.indices),sf(f,e),f}function Qu(r,e){let t="GEOMETRY_CONTAINER",n=new DataView(r.buffer,r.byteOffset,r.length);(r.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&w(t,e,"no binary glTF 2.0"),n.getUint32(8,!0)!==r.length&&w(t,e,"the length in the header is not that of the entry");let s=[];for(let i=12;i<r.length;){i+8>r.length&&w(t,e,"a chunk is cut short");let o=n.getUint32(i,!0),c=n.getUint32(i+4,!0);(o%4||i+8+o>r.length)&&w(t,e,`a chunk of ${o} bytes`),s.push([c,r.subarray(i+8,i+8+o)]),i+=8+o}return s.map(([i])=>i).join()!==[1313821514,5130562].join()&&w(t,e,"not the chunks JSON and BIN"),s[0][1].length>65536&&w(t,e,"JSON of more than 64 KiB"),{json:Ht(s[0][1],e,t),bin:s[1][1]}}function ef(r,e,t,n){let s=r.accessors[t];s||w("GEOMETRY_RANGE",n,`no accessor ${t}`);let i=r.bufferViews[s.bufferView];i||w("GEOMETRY_RANGE",n,`no buffer view ${s.bufferView}`);let o=Ku[s.componentType],c=Ju[s.type],l=o.BYTES_PER_ELEMENT*c,f=i.byteStride??l,h=(i.byteOffset??0)+(s.byteOffset??0),m=(s.byteOffset??0)+f*(s.count-1)+l;(m>i.byteLength||(i.byteOffset??0)+i.byteLength>e.length)&&w("GEOMETRY_RANGE",n,`accessor ${t} reaches past its bytes`),h%4&&w("GEOMETRY_PROFILE",n,`accessor ${t} is not aligned`);let _=f===l?Bt(o,e,h,c*s.count):new o(c*s.count);if(f!==l){let v=Bt(o,e,h,Math.floor(m-(s.byteOffset??0))/o.BYTES_PER_ELEMENT),x=f/o.BYTES_PER_ELEMENT;for(let A=0;A<s.count;A++)for(let N=0;N<c;N++)_[c*A+N]=v[x*A+N]}return Object.assign(_,{items:c})}function tf({positions:r,normals:e,uvs:t,indices:n},s){let i=r.length/3;(e.length!==r.length||t&&t.length!==2*i||!i)&&w("GEOMETRY_ARRAY",s,"attributes of different counts"),(n.length%3||!n.length)&&w("GEOMETRY_ARRAY",s,"part of a triangle")}function nf(r,e,t,n){["min","max"].every(i=>{if(r[i]?.length!==3)return!1;for(let o=0;o<3;o++){let c=e[o];for(let f=o;f<e.length;f+=3)(i==="min"?e[f]<c:e[f]>c)&&(c=e[f]);if((t?r[i][o]:Math.fround(r[i][o]))!==c&&Number.isFinite(c))return!1}return!0})||w("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function rf({positions:r,normals:e,uvs:t},{translation:n,scale:s}){return{positions:Float32Array.from(r,(i,o)=>n[o%3]+s[0]*i),normals:Float32Array.from(e,i=>Math.max(i/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,i=>i/65535):t)}}function sf({positions:r,normals:e,uvs:t,indices:n},s){for(let o of[r,e,t??[]])for(let c=0;c<o.length;c++)Number.isFinite(o[c])||w("GEOMETRY_NOT_FINITE",s,"an attribute is not finite");let i=r.length/3;for(let o=0;o<n.length;o++)n[o]>=i&&w("GEOMETRY_INDEX",s,`vertex ${n[o]} of ${i}`);for(let o=0;o<e.length;o+=3){let c=Math.hypot(e[o],e[o+1],e[o+2]);Math.abs(c-1)>.001&&w("GEOMETRY_NORMAL",s,`a normal of length ${c}`)}}var of={float16:"F16",float32:"F32",int8:"I8"},Fs=1e18;function Cs(r,{planePrecision:e,resolution:t,channels:n},s){let i=st(r,s,"PLANES_HEADER"),{tensors:o}=i,c=e==="int8",l=c?{scales:["F32",[3,n]],planes:["I8",[3,t,t,n]]}:{planes:[of[e],[3,t,t,n]]},f=Object.keys(l),h=Object.keys(o);ot(i.metadata)||w("PLANES_TENSOR",s,"__metadata__ is no object"),(h.length!==f.length||f.some(x=>!h.includes(x)))&&w("PLANES_TENSOR",s,`found ${h.join(", ")||"no tensors"}, expected ${f.join(", ")}`);for(let x of f)it(o[x])||w("PLANES_HEADER",s,`${x} is no tensor`);for(let x of f){let[A,N]=l[x],D=o[x];D.dtype!==A&&w("PLANES_DTYPE",s,`${x}: found ${D.dtype}, expected ${A}`),D.shape.join()!==N.join()&&w("PLANES_SHAPE",s,`${x}: found [${D.shape}], expected [${N}]`)}let m=at(r,i,f,s,"PLANES_HEADER");i.data%64&&w("PLANES_ALIGNMENT",s,"data does not start at a multiple of 64");let _=m.at(-1),v=c?m[0]:null;return af(e,_,v,s),{values:_,scales:v,resolution:t,channels:n,precision:e}}function af(r,e,t,n){let s=()=>w("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${Fs}`);if(r==="int8")t.some(i=>!(Math.abs(i)*128<=Fs))&&s();else if(r==="float16")for(let i=0;i<e.length;i++)(e[i]&31744)===31744&&s();else for(let i=0;i<e.length;i++)Math.abs(e[i])<=Fs||s()}var cf=8192;function Vo(r,e,t,n,s){let i=st(r,n,s),o=i.tensors[e];ot(i.metadata)||w(s,n,"__metadata__ is no object"),(Object.keys(i.tensors).join()!==e||!it(o))&&w(s,n,`not one tensor ${e}`);let[c,l,f]=o.shape,h=o.shape.length===3&&[c,l].every(_=>_>=1&&_<=cf);(o.dtype!=="U8"||!h||!t.includes(f))&&w(s,n,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${t.join(" or ")}]`),i.data%64&&w(s,n,"data does not start at a multiple of 64");let[m]=at(r,i,[e],n,s);return{values:m,height:c,width:l,channels:f}}function Xo(r,e,t){let n="TRANSMITTANCE_TEXTURE",s=Vo(r,"transmittance",[1,3],t,n);return e.cutoff!==void 0&&s.channels!==1&&w(n,t,"a cutoff of a coloured texture"),s}function Ko(r,e){return Vo(r,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function zs({triangles:[r,e]},t,n,s,i){r+e>n.indices.length/3&&w(`${i}_RANGE`,s,`triangles ${r} to ${r+e} of ${n.indices.length/3}`),(i==="NORMAL_MAP"||t.width*t.height>1)&&!n.uvs&&w(`${i}_UV`,s,"the mesh has no texture coordinates")}var lf=65536,jt=class r{static async open(e){let t=new r;return t.source=e,t.directory=await lo(e),t.cache=new Map,t.manifest=Bo(await t._stored(Dt)),$o(t.manifest,t.directory),t.environment=Fo(t.manifest),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(n=>n.name===e):this.manifest.tiers[0];if(!t){let n=this.manifest.tiers.map(s=>s.name).join(", ");w("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${n}`)}return t}bytesOf(e){return this._ranges(this._needed(e,!0)).reduce((t,[n,s])=>t+s-n,0)}prefetch(e,t){this._fetch([...this.poster?[this.poster.image]:[],...this._needed(e,t)])}async load(e,{wantsLobes:t=!1}={}){let n=this.tier(e),s=this._entriesOf(n),i=new Map;this._fetch(this._needed(e,t));for(let c of s)i.set(c,await this._data(c));let o=this.manifest.parts.map((c,l)=>this._part(c,n.parts[l],l,i));return t&&this.environment&&await this._addEnvironment(o,n,i),{name:n.name,tier:n,parts:o}}async _addEnvironment(e,t,n){let s=fr(this.environment).filter(i=>!n.has(i));for(let i of s)n.set(i,await this._data(i));this.environment.forEach((i,o)=>{e[o].environment=this._environment(e[o],i,t.parts[o],n)})}_environment(e,t,n,s){let{inputs:i,lobes:o,visibility:c}=t,l=(e.mesh?.positions??e.curves.points).length/3,h=["planes","resolution","channels","planePrecision"].every(v=>t[v]===n[v])?e.planes:Cs(s.get(t.planes),t,t.planes),m=c?zo(s.get(c),l,c):null,_=c?Gt:0;return{inputs:i,lobes:o,harmonics:m,planes:h,...Us(s,t,t,"environment",9*o,_)}}async posterImage(){return this.poster?(this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,n,s){let{kind:i,bounds:o,geometry:c}=e,l=`/parts/${n}`,f=s.get(c),h={name:e.name,kind:i,bounds:uf(o),inputs:t.inputs};return i==="surface"?h.mesh=Wo(f,c):h.curves=_o(f,c),h.transmittance=(e.transmittance??[]).map(m=>{let _=Xo(s.get(m.texture),m,m.texture);return zs(m,_,h.mesh,l,"TRANSMITTANCE"),{...m,texture:_}}),h.normalMaps=(e.normalMaps??[]).map(m=>{let _=Ko(s.get(m.texture),m.texture);return zs(m,_,h.mesh,l,"NORMAL_MAP"),{...m,texture:_}}),h.planes=Cs(s.get(t.planes),t,t.planes),h.transport=Us(s,t,t,"transport",6),h.emission=t.emission?{inputs:t.emission.inputs,...Us(s,t,t.emission,"emission",3)}:null,h}_entriesOf(e){let t=[];for(let n of this.manifest.parts){t.push(n.geometry);for(let s of[...n.transmittance??[],...n.normalMaps??[]])t.push(s.texture)}for(let n of e.parts)t.push(n.planes,n.decoder),n.emission&&t.push(n.emission.decoder);return[...new Set(t)]}_needed(e,t){return[...new Set([...this._entriesOf(this.tier(e)),...fr(t&&this.environment||[])])]}_ranges(e){let t=e.map(s=>this.directory.get(s)).sort((s,i)=>s.header-i.header),n=[];for(let{header:s,end:i}of t){let o=n.at(-1);o&&s-o[1]<=lf?o[1]=i:n.push([s,i])}return n}_fetch(e){let t=e.filter(s=>!this.cache.has(s)),n=this._ranges(t);if(t.length){this.source.expect(n);for(let[s,i]of n){let o=this.source.read(s,i),c=f=>f.header>=s&&f.end<=i,l=t.filter(f=>c(this.directory.get(f)));for(let f of l)this.cache.set(f,{bytes:o,start:s});o.catch(()=>l.forEach(f=>this.cache.delete(f)))}}}async _stored(e){let t=this.directory.get(e),{bytes:n,start:s}=this.cache.get(e)??{},i=n?(await n).subarray(t.header-s,t.end-s):await this.source.read(t.header,t.end);return uo(t,i)}async _data(e){let t=await this._stored(e);await Jo(t,this.manifest.entries[e].sha256,e);let n=this.manifest.extensions?.RNA_deflate?.entries[e];if(!n)return t;let s=await Mo(t,n,e);return await Jo(s,n.sha256,e),s}};function Us(r,e,t,n,s,i=0){let c={columns:t.inputs.reduce((l,f)=>l+ur(f,e.channels),i),outputs:s,output:n,precision:t.decoderPrecision};return Oo(r.get(t.decoder),c,t.decoder)}function uf({min:r,max:e}){return{min:r.map(Math.fround),max:e.map(Math.fround)}}async function Jo(r,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",r))].map(i=>i.toString(16).padStart(2,"0")).join("")!==e&&w("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var ff=["maxStorageBufferBindingSize","maxBufferSize"];async function Qo(){let r=await navigator.gpu?.requestAdapter({powerPreference:"high-performance"});if(!r){let t=navigator.gpu?"WebGPU has no adapter here":isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine";throw new G(`${t}: only the poster is shown`)}let e=Object.fromEntries(ff.map(t=>[t,r.limits[t]]));return r.requestDevice({requiredLimits:e})}function ne(r,e,t=GPUBufferUsage.STORAGE,n="a buffer"){let s=typeof e=="number"?e:e.byteLength,i=Math.max(16,Math.ceil(s/16)*16),o=r.limits.maxStorageBufferBindingSize;if(i>o)throw new G(`${n} takes ${dt(i)}; this GPU allows ${dt(o)}`);let c=r.createBuffer({size:i,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(c.getMappedRange()).set(l),c.unmap()}return c}async function pr(r,e){let t=r.createShaderModule({code:e}),{messages:n}=await t.getCompilationInfo(),s=n.find(({type:i})=>i==="error");if(s)throw new Error(`a shader does not compile, line ${s.lineNum}: ${s.message}`);return t}var yn=(r,e,t,n)=>Ce(r,e.getBindGroupLayout(t),n);function Ie(r,e){let t=Object.entries(e).map(([n,s])=>({binding:Number(n),visibility:GPUShaderStage.COMPUTE,buffer:{type:s}}));return r.createBindGroupLayout({entries:t})}function Ce(r,e,t){let n=Object.entries(t).map(([s,i])=>({binding:Number(s),resource:{buffer:i}}));return r.createBindGroup({layout:e,entries:n})}function he(r,e,t,n){let s=Math.max(1,Math.ceil(n/64)),i=Math.min(s,32768);r.setPipeline(e),t.forEach((o,c)=>r.setBindGroup(c,o)),r.dispatchWorkgroups(i,Math.ceil(s/i))}async function wn(r,e,t){let n=r.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),s=r.createCommandEncoder();s.copyBufferToBuffer(e,0,n,0,n.size),r.queue.submit([s.finish()]),await n.mapAsync(GPUMapMode.READ);let i=n.getMappedRange().slice(0);return n.destroy(),i}var hf={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function ea(r,e,t,n,s=!0){let i=r.parts[e][t],{device:o,queue:c,bandPixels:l}=r,f=t==="transport"?2:1,h=n.length/16,m=new Float32Array(3*f*h);for(let _=0;_<h;_+=l){let v=Math.min(l,h-_);if(o.queue.writeBuffer(c.rows,0,n,16*_,16*v),o.queue.writeBuffer(c.count,0,Uint32Array.of(v)),r._run(A=>i.run(A,c,v)),await r.done(),!s)continue;let x=new Float32Array(await wn(o,c.answers,16*f*v));for(let A=0;A<f*v;A++)m.set(x.subarray(4*A,4*A+3),3*(f*_+A))}return m}async function ta(r,e,t,n){let{device:s,band:i}=r,{words:o,members:c}=ue.Pixel,l=new Uint32Array(o*e.length);e.forEach(({place:h,b1:m,b2:_,x:v,wi:x,part:A},N)=>{let D=(q,X)=>[...new Uint32Array(Float32Array.from(q).buffer),X];l.set(ce("Pixel",{position:D(v,0),axis:[0,0,0,A+1],wo:[0,0,0,h],wi:D(x,0),b1:m,b2:_}),o*N)}),r.resize(e.length,1),r.span={first:0,pixels:e.length,jitter:0},s.queue.writeBuffer(i,0,l),r._writeFrame(hf,0),r._writeView({kind:"given",colour:[1,1,1]}),r._run(h=>he(h,t,r.groups.rays,e.length));let f=new Float32Array(await wn(s,i,l.byteLength));return Float32Array.from({length:3*e.length},(h,m)=>f[o*Math.floor(m/3)+c[n].at+m%3])}var na=(r,e)=>ta(r,e,r.kernels.light,"visibility");async function ra(r,e){let t=await r.pipelines.get(r.raySources.hit,"find_normals",r.rayLayout);return ta(r,e,t,"axis")}var Ds=r=>Uint8Array.from(atob(r),e=>e.charCodeAt(0));function Hs(r){let e=new Uint8Array(r.buffer,r.byteOffset,r.byteLength),t="";for(let n=0;n<e.length;n+=8192)t+=String.fromCharCode(...e.subarray(n,n+8192));return btoa(t)}var mr=class{constructor(e){this.engine=e}async load(e,t){let n=await jt.open(new Tt(new Blob([Ds(e)]),"package"));this.shown=await n.load(t),this.arrays=await nr(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,n){let s=t==="transport"?13:10,i=new Float32Array(Ds(n).buffer),o=new Float32Array(16*i.length/s);for(let c=0;16*c<o.length;c++){let l=i.subarray(s*c,s*(c+1)),f=l.subarray(7,10);o.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...f,0,...s===13?l.subarray(10):f],16*c)}return Hs(await this.answer(e,t,o))}answer(...e){return ea(this.engine,...e)}async visibility(e){return Hs(await na(this.engine,this._hits(e)))}async normals(e){return Hs(await ra(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=Ds(e),n=new Uint32Array(t),s=new Float32Array(t),i=[];for(let o=0;o<n.length;o+=8){let c=n[o+7],{first:l,fiber:f}=this.arrays.parts[c],h=s.subarray(o,o+7),m=this.arrays.where[l+n[o]];i.push(f?{place:m,part:c,b1:0,b2:0,x:h.slice(1,4),wi:h.slice(4,7)}:{place:m,part:c,b1:h[1],b2:h[2],x:[0,0,0],wi:h.slice(3,6)})}return i}};var Zt=.4*Math.PI/180,Yt=5*Math.PI/180,dr=.05;function sa(r,e,t=()=>!0){let n=new Map,s=null;r.addEventListener("pointerdown",o=>{t(o)&&(n.set(o.pointerId,{x:o.clientX,y:o.clientY}),pf(r,o.pointerId),r.classList.add("dragging"),n.size>1?s=n.size===2?"two":"three":n.size===1&&(s=o.button===2?"pan":o.button!==0?null:o.altKey||o.shiftKey?"light":"orbit"))}),r.addEventListener("pointermove",o=>{let c=n.get(o.pointerId);if(!c)return;let l={x:o.clientX,y:o.clientY},f=l.x-c.x,h=l.y-c.y;s==="two"&&mf(n,o.pointerId,c,l,e,r.clientHeight),n.set(o.pointerId,l),!(!f&&!h)&&(s==="orbit"&&e.orbit(-f*Zt,h*Zt,!0),s==="three"&&e.light(f/3*Zt,-h/3*Zt,!0),s==="light"&&e.light(f*Zt,-h*Zt,!0),s==="pan"&&e.pan(-f/r.clientHeight,h/r.clientHeight,!0))});for(let o of["pointerup","pointercancel"])r.addEventListener(o,c=>{n.delete(c.pointerId)&&(n.size||(s=null,r.classList.remove("dragging"),e.settle()))});r.addEventListener("contextmenu",o=>t(o)&&o.preventDefault()),r.addEventListener("dblclick",o=>t(o)&&e.reset());let i=0;r.addEventListener("wheel",o=>{if(!t(o))return;o.preventDefault();let c=o.deltaMode===0?o.deltaY:o.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,c))*.0012),!0),clearTimeout(i),i=setTimeout(()=>e.settle(),200)},{passive:!1}),r.addEventListener("keydown",o=>t(o)&&df(o,e))}function pf(r,e){try{r.setPointerCapture(e)}catch{}}function mf(r,e,t,n,s,i){let o=[...r].find(([m])=>m!==e)?.[1];if(!o)return;let c=m=>Math.hypot(m.x-o.x,m.y-o.y)||1,l=m=>Math.atan2(m.y-o.y,m.x-o.x);s.zoom(c(t)/c(n),!0);let f=l(n)-l(t),h=Math.atan2(Math.sin(f),Math.cos(f));h&&s.light(-h,0,!0),s.pan(.5*(t.x-n.x)/i,.5*(n.y-t.y)/i,!0)}function df(r,e){if(r.ctrlKey||r.metaKey)return;let t=r.altKey||r.shiftKey?e.light:e.orbit,n={ArrowLeft:()=>t(-Yt,0),ArrowRight:()=>t(Yt,0),ArrowUp:()=>t(0,Yt),ArrowDown:()=>t(0,-Yt),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),a:()=>e.pan(-dr,0),d:()=>e.pan(dr,0),w:()=>e.pan(0,dr),s:()=>e.pan(0,-dr),"[":()=>e.light(-Yt,0),"]":()=>e.light(Yt,0),Home:()=>e.reset()},s=r.key.length===1?r.key.toLowerCase():r.key;Object.hasOwn(n,s)&&(r.preventDefault(),n[s]())}var{RNA_NONE:la,MAX_LAYERS:ia,MAX_EXACT_INPUTS:oa,RNA_CHANNEL_GROUPS:aa}=ie,Wt=r=>Math.ceil(r/4);function _r(r,e,t,n=0){gf(e);let{places:s,slots:i,queryGroups:o}=_f(t,r.planes.channels,n),c=new Bs,l=la;e.int8&&(l=c.add(gr(e.gain,s,o)),c.add(gr(e.offset,s,o)));let f=e.layers.map((x,A)=>ca(c,x,A?null:s,A?0:o)),h=null;if(e.matrix){let x=e.matrix.length/e.outputs,A=new Float32Array(e.outputs);h=ca(c,{weight:e.matrix,bias:A,rows:x,columns:e.outputs,relu:!1},null,0)}let m=[...f,...h?[h]:[]],_=Math.max(...m.flatMap(({inputs:x,outputs:A})=>[x,A])),v=vf(r,e,{queryGroups:o,gain:l,slots:i,layers:f,matrix:h});return{weights:c.all(),record:v,groups:Math.max(4,2**Math.ceil(Math.log2(_)))}}function gf({layers:r,int8:e}){if(r.length>ia)throw new G(`a decoder of ${r.length} layers; at most ${ia}`);let t=e?Math.max(...r.map(({rows:n})=>n)):0;if(t>oa)throw new G(`an int8 layer of ${t} inputs; at most ${oa}`)}function _f(r,e,t){let n=[],s=lr.map(()=>la),i=0;for(let o of r){let c=ur(o,e);s[lr.indexOf(_t(o))]=i;for(let l=0;l<c;l++)n.push(4*i+l);i+=Wt(c)}for(let o=0;o<t;o++)n.push(4*i+o);return i+=Wt(t),{places:n,slots:s,queryGroups:i}}var Bs=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let n of this.list)e.set(n,t),t+=n.length;return e}};function gr(r,e,t){let n=new Float32Array(4*t);return r.forEach((s,i)=>{n[e?e[i]:i]=s}),n}function ca(r,{weight:e,bias:t,rows:n,columns:s,step:i=0,scales:o,relu:c},l,f){let h=f||Wt(n),m=Wt(s),_=new Float32Array(16*h*m);for(let N=0;N<n;N++){let D=l?l[N]:N,q=D>>2;for(let X=0;X<s;X++)_[16*((X>>2)*h+q)+4*(D&3)+(X&3)]=e[N*s+X]}let v=r.add(_),x=r.add(gr(t,null,m)),A=o?r.add(gr(Float32Array.from(o,N=>N*i),null,m)):0;return{inputs:h,outputs:m,weights:v,bias:x,units:A,relu:Number(c),int8_step:i}}function vf(r,e,{queryGroups:t,gain:n,slots:s,layers:i,matrix:o}){let{resolution:c,channels:l,precision:f,scales:h}=r.planes,{low:m,high:_,top:v,unit:x}=e,A=new Float32Array(12*aa);for(let N=0;h&&N<3;N++)A.set(h.subarray(N*l,(N+1)*l),4*aa*N);return ce("RnaPart",{low:r.bounds.min,high:r.bounds.max,resolution:c,channel_groups:Wt(l),query_groups:t,layer_count:i.length,plane_precision:ie[`RNA_${f.toUpperCase()}`],gain:n,query_low:m,query_high:_,top:v,unit:x,matrix:o??{},scales:A,layers:i,slots:s})}function ua({values:r,resolution:e,channels:t},n){let s=e*e,i=r.subarray(n*s*t,(n+1)*s*t),o=4*Wt(t);if(o===t)return i;let c=new r.constructor(s*o);for(let l=0;l<s;l++)c.set(i.subarray(l*t,(l+1)*t),l*o);return c}var wt={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["row_records.wgsl","arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/lobe_constants.wgsl"],columns:["geometry_records.wgsl","queue"],queue:["row_records.wgsl","render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},ft={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
// by their bits, since WGSL may assume that there is no NaN, and may take subnormal numbers for 0.

const RNA_EXPONENT: u32 = 0x7f800000u;

fn rna_is_finite(bits: vec4<u32>) -> bool {
    return all((bits & vec4<u32>(RNA_EXPONENT)) != vec4<u32>(RNA_EXPONENT));
}

// A component, divided by 2^(largest - 127); of a subnormal largest 0, by 2^-149.
fn rna_scaled(bits: u32, largest: u32) -> f32 {
    let exponent = (bits & RNA_EXPONENT) >> 23u;
    let mantissa = f32(bits & 0x7fffffu);
    var size = 0.0;
    if largest == 0u {
        size = mantissa;
    } else if exponent != 0u {
        let down = largest - exponent;
        if down < 64u {
            size = bitcast<f32>(((127u - down) << 23u) | (bits & 0x7fffffu));
        }
    } else if largest < 64u {
        size = mantissa * bitcast<f32>((105u - largest) << 23u);
    }
    return select(size, -size, (bits >> 31u) == 1u);
}

// The unit vector along one of any length; 0 of length 0.
fn rna_unit(bits: vec3<u32>) -> vec3f {
    let exponents = (bits & vec3<u32>(RNA_EXPONENT)) >> vec3<u32>(23u);
    let largest = max(exponents.x, max(exponents.y, exponents.z));
    let v = vec3f(
        rna_scaled(bits.x, largest), rna_scaled(bits.y, largest), rna_scaled(bits.z, largest),
    );
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
`,"blocks.wgsl":`// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
// a group of 4 columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// Writes \`features\`, \`position\`, \`wo\` and \`wi\`; returns the first three features.
fn rna_common_blocks(x: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let p = rna_relative(x);
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, \`instead\` where they are opposite ("In float32": the difference of
// their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f, instead: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return instead;
    }
    return s / size;
}
`,"bvh.wgsl":`// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they call
//     fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool
// which opaque.wgsl answers, or a host that knows what lets light through; found: (t, b1, b2).

// Nodes to come back to: of the tree over instances, then of a body's. Private, since a function's own
// array would be set to 0 at every call.
var<private> rna_stack: array<u32, 2u * RNA_STACK>;

fn rna_inverse(d: vec3f) -> vec3f {
    let tiny = select(vec3f(1e-20), vec3f(-1e-20), d < vec3f(0.0));
    return vec3f(1.0) / select(d, tiny, abs(d) < vec3f(1e-20));
}

// Where the ray enters a node's box; RNA_FAR where it does not.
fn rna_enter_node(node: u32, origin: vec3f, inverse: vec3f, near: f32, far: f32) -> f32 {
    let a = (rna_nodes[node].low - origin) * inverse;
    let b = (rna_nodes[node].high - origin) * inverse;
    let lower = min(a, b);
    let upper = max(a, b);
    let enter = max(max(lower.x, lower.y), max(lower.z, near));
    let leave = min(min(upper.x, upper.y), min(upper.z, far));
    return select(RNA_FAR, enter, enter <= leave * 1.0000005);
}

// The next node down, nearer child first; RNA_NOTHING where none is hit.
fn rna_descend(
    node: u32, ray: RnaRay, inverse: vec3f, far: f32, top: ptr<function, u32>,
) -> u32 {
    let left = node + 1u;
    let right = rna_nodes[node].child;
    let to_left = rna_enter_node(left, ray.origin, inverse, ray.near, far);
    let to_right = rna_enter_node(right, ray.origin, inverse, ray.near, far);
    if to_left >= RNA_FAR && to_right >= RNA_FAR {
        return RNA_NOTHING;
    }
    if to_left >= RNA_FAR {
        return right;
    }
    if to_right >= RNA_FAR {
        return left;
    }
    let left_first = to_left <= to_right;
    rna_stack[*top] = select(left, right, left_first);
    *top += 1u;
    return select(right, left, left_first);
}

// Tests a primitive; whether it is hit nearer than \`hit\`, which is then set to it.
fn rna_meet(primitive: u32, ray: RnaRay, start_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if !rna_is_segment(record) {
        let found = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if found.x >= RNA_FAR || !rna_stops(primitive, ray, found, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(found.x, (*hit).instance, primitive, found.y, found.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == start_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, 0.0, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below \`root\`, ray in its object space, nearer than \`hit\`; with \`any\`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, start_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var found = false;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_meet(first + k, ray, start_strand, hit) {
                found = true;
                if any {
                    return true;
                }
            }
        }
        if next == RNA_NOTHING {
            if top == RNA_STACK {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return found;
}

// Tests an instance, world ray; \`own\` is passed through, and so is what \`rays\` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, own: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == own || (rna_instances[instance].rays & rays) == 0u {
        return false;
    }
    let scale = rna_instances[instance].scale;
    let local = rna_to_object(ray, instance);
    var nearest = *hit;
    nearest.instance = instance;
    nearest.t = min((*hit).t / scale, RNA_FAR);
    if !rna_trace_body(rna_instances[instance].root, local, RNA_NOTHING, any, &nearest) {
        return false;
    }
    nearest.t *= scale;
    *hit = nearest;
    return true;
}

// The closest hit in the world, or with \`any\` some hit.
fn rna_trace(ray: RnaRay, own: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_trace_instance(first + k, ray, own, rays, any, &hit) && any {
                return hit;
            }
        }
        if next == RNA_NOTHING {
            if top == 0u {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return hit;
}
`,"decoder.wgsl":`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

struct RnaTransport {
    visible: vec3f, // of emission: what is emitted
    shadowed: vec3f,
}

// Clip, and gain and offset of an int8 decoder.
fn rna_prepare_queries() {
    for (var k = 0u; k < rna_part.query_groups; k++) {
        var x = clamp(rna_values[k], vec4f(rna_part.query_low), vec4f(rna_part.query_high));
        if rna_part.gain != RNA_NONE {
            x = x * rna_weight(rna_part.gain + k)
                + rna_weight(rna_part.gain + rna_part.query_groups + k);
        }
        rna_values[k] = x;
    }
}

// QuantizeLinear: whole numbers from 0 to 255, halves to even.
fn rna_quantize(layer: RnaLayer, source: u32) {
    for (var k = 0u; k < layer.inputs; k++) {
        let x = rna_values[source + k] / layer.int8_step;
        rna_values[source + k] = clamp(round(x), vec4f(0.0), vec4f(255.0));
    }
}

// What a group of columns adds to the sums of an output group, with its block at \`at\`.
fn rna_block(x: vec4f, at: u32) -> vec4f {
    return x.x * rna_weight(at) + x.y * rna_weight(at + 1u)
        + x.z * rna_weight(at + 2u) + x.w * rna_weight(at + 3u);
}

fn rna_finish(layer: RnaLayer, o: u32, sums: vec4f, place: u32) {
    var y = sums + rna_weight(layer.bias + o);
    if layer.int8_step != 0.0 {
        y *= rna_weight(layer.units + o);
    }
    if layer.relu == 1u {
        y = max(y, vec4f(0.0));
    }
    rna_values[place + o] = y;
}

// Four output groups at a time: a value is read once for 16 sums. Sums of int8 layers are whole
// and below 2^24: exact.
fn rna_run_layer(layer: RnaLayer, source: u32, place: u32) {
    if layer.int8_step != 0.0 {
        rna_quantize(layer, source);
    }
    let stride = 4u * layer.inputs;
    var o = 0u;
    for (; o + 4u <= layer.outputs; o += 4u) {
        var a = vec4f(0.0);
        var b = vec4f(0.0);
        var c = vec4f(0.0);
        var d = vec4f(0.0);
        var at = layer.weights + o * stride;
        for (var k = 0u; k < layer.inputs; k++) {
            let x = rna_values[source + k];
            a += rna_block(x, at);
            b += rna_block(x, at + stride);
            c += rna_block(x, at + 2u * stride);
            d += rna_block(x, at + 3u * stride);
            at += 4u;
        }
        rna_finish(layer, o, a, place);
        rna_finish(layer, o + 1u, b, place);
        rna_finish(layer, o + 2u, c, place);
        rna_finish(layer, o + 3u, d, place);
    }
    for (; o < layer.outputs; o++) {
        var sums = vec4f(0.0);
        for (var k = 0u; k < layer.inputs; k++) {
            sums += rna_block(rna_values[source + k], layer.weights + o * stride + 4u * k);
        }
        rna_finish(layer, o, sums, place);
    }
}

// What the last layer gives, clipped, as radiance.
fn rna_expand(source: u32) {
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
}

// The place of the results in rna_values, from the queries there.
fn rna_run_decoder() -> u32 {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k <= rna_part.layer_count; k++) {
        var layer = rna_part.matrix;
        if k < rna_part.layer_count {
            layer = rna_part.layers[k];
        } else {
            rna_expand(source);
        }
        if layer.inputs == 0u {
            break; // there is no matrix
        }
        rna_run_layer(layer, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    return source;
}

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    let source = rna_run_decoder();
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
}
`,"environment_lobes.wgsl":`// Lobes of the transport for light from whole environments: spec/RNA.md, 12, RNA_environment. Whoever composes the files
// declares RNA_LOBES, RNA_IS_FIBER (1 or 0) and RNA_VISIBILITY_GROUPS: 4, or 0 of parts without harmonics.

const RNA_AXIS_SHIFT: f32 = 8.0;
const RNA_LEAST_KAPPA: f32 = 0.01;
const RNA_WIDE: f32 = 2.0; // kappa of a lobe that the decoder leaves as it is, of the first half
const RNA_SHARP: f32 = 10.0; // and of the rest

struct RnaLobe {
    amplitude: vec3f,
    kappa: f32,
    axis: vec3f, // its length is kappa, but for those below RNA_LEAST_KAPPA
}

// Runs the decoder. m: the mirror direction. visibility: harmonics of the asset's own, coefficients. The result is where
// rna_lobe finds its values.
fn rna_run_lobes(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, m: vec3f, visibility: array<vec4f, 4>,
) -> u32 {
    rna_put_queries(x, axis, h, wo, m);
    let first = rna_part.query_groups - RNA_VISIBILITY_GROUPS;
    for (var k = 0u; k < RNA_VISIBILITY_GROUPS; k++) {
        rna_values[first + k] = visibility[k];
    }
    return rna_run_decoder();
}

fn rna_three(place: u32, k: u32) -> vec3f {
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return max(vec3f(x, y, z), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), free);
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// RNA_COLOURS, 2 of transport and 1 of emission, is declared by whoever composes the files.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_COLOURS * row] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[2u * row + 1u] = vec4f(result.shadowed, 0.0);
    }
}

@compute @workgroup_size(64)
fn rna_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= rna_row_count[0] {
        return;
    }
    let at = rna_rows[row];
    let finite = rna_is_finite(vec4<u32>(at.position, at.h)) && rna_is_finite(vec4<u32>(at.axis, 0u))
        && rna_is_finite(vec4<u32>(at.wo, 0u)) && rna_is_finite(vec4<u32>(at.wi, 0u));
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi);
}
`,"fiber_blocks.wgsl":`// Input blocks of fibers alone: spec/RNA.md, 6.3 Input blocks and "In float32".

const RNA_ETA: f32 = 1.55;

// c_o, cos phi and sin phi. Products with t have lost the component along it: t x wo and t x wi
// have the lengths c_o and c_i, and phi is between them.
fn rna_azimuth(t: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let o = cross(t, wo);
    let i = cross(t, wi);
    let c_o = length(o);
    let d = c_o * length(i);
    if d < 1e-6 {
        return vec3f(c_o, 1.0, 0.0);
    }
    return vec3f(c_o, clamp(dot(o, i) / d, -1.0, 1.0), clamp(dot(t, cross(o, i)) / d, -1.0, 1.0));
}

// Cosine and sine of twice the angle within 90 degrees that has this sine.
fn rna_doubled(sine: f32) -> vec2f {
    let cosine = sqrt(max(0.0, (1.0 - sine) * (1.0 + sine)));
    return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * cosine);
}

// cos(phi - Phi_p) for p = 0, 1, 2, by the addition theorems; each segment turns by -2 g_t - pi.
fn rna_lobes(h: f32, s_o: f32, azimuth: vec3f) -> vec3f {
    let segment = rna_doubled(h * azimuth.x / sqrt(RNA_ETA * RNA_ETA - s_o * s_o));
    let r = rna_doubled(h);
    let tt = vec2f(-r.x * segment.x - r.y * segment.y, r.x * segment.y - r.y * segment.x);
    let trt = vec2f(-tt.x * segment.x - tt.y * segment.y, tt.x * segment.y - tt.y * segment.x);
    let phi = azimuth.yz;
    return vec3f(dot(phi, r), dot(phi, tt), dot(phi, trt));
}

fn rna_fiber_blocks(t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_TANGENT), vec4f(t, 0.0));
    rna_put(rna_slot(RNA_BLOCK_H), vec4f(h, 0.0, 0.0, 0.0));
    let angles = rna_slot(RNA_BLOCK_FIBER_ANGLES);
    let lobes = rna_slot(RNA_BLOCK_FIBER_LOBES);
    if angles == RNA_NONE && lobes == RNA_NONE {
        return;
    }
    let s_o = dot(t, wo);
    let s_i = dot(t, wi);
    let cone = s_i + s_o;
    let azimuth = rna_azimuth(t, wo, wi);
    if angles != RNA_NONE {
        rna_values[angles] = vec4f(s_i, s_o, cone, log2(cone * cone + 1e-3) / 6.0);
        rna_values[angles + 1u] = vec4f(azimuth.yz, 0.0, 0.0);
    }
    rna_put(lobes, vec4f(rna_lobes(h, s_o, azimuth), 0.0));
}
`,"geometry.wgsl":`// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; instances place the bodies in the world. \`geometry.py\` fills them.

// The tree over instances comes first.
@group(2) @binding(0) var<storage, read> rna_nodes: array<RnaNode>;

@group(2) @binding(1) var<storage, read> rna_primitives: array<RnaPrimitive>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

@group(2) @binding(3) var<storage, read> rna_instances: array<RnaInstance>;

const RNA_FAR: f32 = 1e30;
const RNA_STACK: u32 = 48u;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct RnaHit {
    t: f32,
    instance: u32, // RNA_NOTHING for a miss
    primitive: u32,
    b1: f32, // barycentric coordinates of a triangle's second and third corner
    b2: f32,
    normal: vec3f, // outward, of a segment
}

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

fn rna_is_segment(primitive: RnaPrimitive) -> bool {
    return (primitive.tag & RNA_IS_SEGMENT) != 0u;
}

fn rna_surface(primitive: RnaPrimitive) -> u32 {
    return primitive.tag >> RNA_SURFACE_SHIFT;
}

// Of a segment.
fn rna_strand(primitive: RnaPrimitive) -> u32 {
    return primitive.c;
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let scale = rna_instances[instance].scale;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[instance].to_object[0], p),
        dot(rna_instances[instance].to_object[1], p),
        dot(rna_instances[instance].to_object[2], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    return d.x * rna_instances[instance].rotation[0].xyz
        + d.y * rna_instances[instance].rotation[1].xyz
        + d.z * rna_instances[instance].rotation[2].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    return vec3f(
        dot(rna_instances[instance].rotation[0].xyz, d),
        dot(rna_instances[instance].rotation[1].xyz, d),
        dot(rna_instances[instance].rotation[2].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    return rna_instances[instance].scale * rna_world_direction(x, instance)
        + rna_instances[instance].place;
}
`,"geometry_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NOTHING: u32 = 0xffffffffu;
const RNA_IS_SEGMENT: u32 = 1u;
const RNA_SURFACE_SHIFT: u32 = 1u;
const RNA_HAS_BEFORE: u32 = 1u;
const RNA_HAS_AFTER: u32 = 2u;

struct RnaNode { // 32 bytes
    low: vec3f, // 0
    child: u32, // 12; the right one, the left one is the next node; a leaf's first primitive
    high: vec3f, // 16
    count: u32, // 28; a leaf's primitives; 0 of inner nodes
}

struct RnaPrimitive { // 16 bytes
    a: u32, // 0; point: a triangle's first corner, a segment's start
    b: u32, // 4; second corner; of a segment RNA_HAS_BEFORE and RNA_HAS_AFTER
    c: u32, // 8; third corner; of a segment its strand
    tag: u32, // 12; surface << RNA_SURFACE_SHIFT, and RNA_IS_SEGMENT
}

struct RnaInstance { // 128 bytes
    to_object: array<vec4f, 3>, // 0; rows of the matrix
    rotation: array<vec4f, 3>, // 48; to the world: rows, the fourth column free
    place: vec3f, // 96; in the world
    scale: f32, // 108; to the world
    root: u32, // 112; node
    rays: u32, // 116; bits of those that can hit it
    extent: f32, // 120; largest coordinate of its body
    own: u32, // 124; a number of the host's
}
`,"normal_maps.wgsl":`// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// at modulo sides. Vulkan leaves \`%\` of a negative number undefined, and drivers differ.
fn rna_repeated(at: vec2<i32>, sides: vec2<i32>) -> vec2<i32> {
    let left = at - at / sides * sides;
    return select(left, left + sides, left < vec2<i32>(0));
}

// x and y of a map of \`size\` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let i = vec2<u32>(rna_repeated(vec2<i32>(low), sides));
    let j = vec2<u32>(rna_repeated(vec2<i32>(low) + 1, sides));
    let upper = mix(rna_map_texel(map, i.y, i.x), rna_map_texel(map, i.y, j.x), part.x);
    let lower = mix(rna_map_texel(map, j.y, i.x), rna_map_texel(map, j.y, j.x), part.x);
    return (mix(upper, lower, part.y) - 127.0) / 127.0;
}

// n: interpolated normal; p: corners; uv: their texture coordinates; b: barycentric coordinates.
fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = sign(area);
    let along_u = (d2.y * e1 - d1.y * e2) * side;
    let along_v = (d1.x * e2 - d2.x * e1) * side;
    let t = along_u - dot(along_u, n) * n;
    if area == 0.0 || length(t) <= 1e-6 * length(along_u) {
        return n;
    }
    let tangent = normalize(t);
    var bitangent = cross(n, tangent);
    if dot(bitangent, along_v) > 0.0 {
        bitangent = -bitangent;
    }
    let xy = rna_map_value(map, size, uv * b);
    let z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
    let m = xy.x * tangent + xy.y * bitangent + z * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}
`,"part.wgsl":`// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
`,"part_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NONE: u32 = 0xffffffffu;
const RNA_FLOAT32: u32 = 0u;
const RNA_FLOAT16: u32 = 1u;
const RNA_INT8: u32 = 2u;
const RNA_BLOCK_FEATURES: u32 = 0u;
const RNA_BLOCK_POSITION: u32 = 1u;
const RNA_BLOCK_NORMAL: u32 = 2u;
const RNA_BLOCK_TANGENT: u32 = 3u;
const RNA_BLOCK_H: u32 = 4u;
const RNA_BLOCK_WO: u32 = 5u;
const RNA_BLOCK_WI: u32 = 6u;
const RNA_BLOCK_HALF_VECTOR: u32 = 7u;
const RNA_BLOCK_HIGHLIGHT: u32 = 8u;
const RNA_BLOCK_LEARNED_NORMAL: u32 = 9u;
const RNA_BLOCK_FIBER_ANGLES: u32 = 10u;
const RNA_BLOCK_FIBER_LOBES: u32 = 11u;
const RNA_CHANNEL_GROUPS: u32 = 16u;

struct RnaLayer { // 32 bytes
    inputs: u32, // 0; groups of 4 columns
    outputs: u32, // 4
    weights: u32, // 8; place of [outputs][inputs][4] vec4f
    bias: u32, // 12; place of [outputs] vec4f
    units: u32, // 16; place of [outputs] vec4f of an int8 layer: what a sum of 1 means
    relu: u32, // 20; 1: negative results are 0
    int8_step: f32, // 24; of an int8 layer: what 1 means in its inputs; else 0
    reserved: u32, // 28
}

struct RnaPart { // 1936 bytes
    low: vec3f, // 0; smallest corner of the bounds
    resolution: u32, // 12
    high: vec3f, // 16
    channel_groups: u32, // 28; channels / 4, rounded up
    query_groups: u32, // 32; of the decoder's input
    layer_count: u32, // 36
    plane_precision: u32, // 40; RNA_FLOAT32, RNA_FLOAT16 or RNA_INT8
    gain: u32, // 44; place of [query_groups] gains, then the offsets; RNA_NONE without
    query_low: f32, // 48; the decoder's first Clip
    query_high: f32, // 52
    top: f32, // 56; of the Clip before Exp
    unit: f32, // 60; result = (exp(x) - 1) unit, or times the matrix; then 1
    matrix: RnaLayer, // 64; [n, 6], with a bias of 0; all 0 without
    scales: array<vec4f, 48>, // 96; of int8 planes, [plane][group]
    layers: array<RnaLayer, 32>, // 864
    slots: array<vec4<u32>, 3>, // 1888; first group of each block, RNA_NONE for none: see rna_slot
}
`,"planes.wgsl":`// Features of a position: spec/RNA.md, 5 Planes.

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}

// The value of a float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: u32) -> f32 {
    let exponent = (bits >> 10u) & 31u;
    let mantissa = bits & 1023u;
    let size = select(
        bitcast<f32>(((exponent + 112u) << 23u) | (mantissa << 13u)),
        f32(mantissa) * 0x1p-24f,
        exponent == 0u,
    );
    return select(size, -size, (bits & 0x8000u) != 0u);
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let at = texel * rna_part.channel_groups + group;
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return vec4f(
                bitcast<f32>(rna_plane_word(plane, 4u * at)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 1u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 2u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 3u)),
            );
        }
        case RNA_FLOAT16: {
            let a = rna_plane_word(plane, 2u * at);
            let b = rna_plane_word(plane, 2u * at + 1u);
            return vec4f(
                rna_from_float16(a & 0xffffu),
                rna_from_float16(a >> 16u),
                rna_from_float16(b & 0xffffu),
                rna_from_float16(b >> 16u),
            );
        }
        default: {
            let word = bitcast<i32>(rna_plane_word(plane, at));
            let integers = vec4<i32>(word << 24u, word << 16u, word << 8u, word) >> vec4<u32>(24u);
            return vec4f(integers) * rna_part.scales[plane * RNA_CHANNEL_GROUPS + group];
        }
    }
}

// Where a position is on one axis: texel, the next one, and the fraction between them.
struct RnaTexel {
    low: vec3<u32>,
    high: vec3<u32>,
    fraction: vec3f,
}

fn rna_texels(p: vec3f) -> RnaTexel {
    let last = f32(rna_part.resolution - 1u);
    let s = clamp(p * f32(rna_part.resolution) - 0.5, vec3f(0.0), vec3f(last));
    let below = floor(s);
    let low = vec3<u32>(below);
    let high = min(low + vec3<u32>(1u), vec3<u32>(rna_part.resolution - 1u));
    return RnaTexel(low, high, s - below);
}

// x: (texel, next) along the columns, y: along the rows.
fn rna_bilinear(
    plane: u32, group: u32, columns: vec2<u32>, rows: vec2<u32>, a: f32, b: f32,
) -> vec4f {
    let lower = rows.x * rna_part.resolution;
    let upper = rows.y * rna_part.resolution;
    let at_lower = (1.0 - a) * rna_texel(plane, lower + columns.x, group)
        + a * rna_texel(plane, lower + columns.y, group);
    let at_upper = (1.0 - a) * rna_texel(plane, upper + columns.x, group)
        + a * rna_texel(plane, upper + columns.y, group);
    return (1.0 - b) * at_lower + b * at_upper;
}

// Position as a fraction of the bounds, clamped to them.
fn rna_relative(x: vec3f) -> vec3f {
    let inside = clamp(x, rna_part.low, rna_part.high);
    return clamp((inside - rna_part.low) / (rna_part.high - rna_part.low), vec3f(0.0), vec3f(1.0));
}

// Channels 4 group to 4 group + 3 of the features at p, in [0, 1].
fn rna_features(t: RnaTexel, group: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var plane = 0u; plane < 3u; plane++) {
        let next = (plane + 1u) % 3u;
        let columns = vec2<u32>(t.low[plane], t.high[plane]);
        let rows = vec2<u32>(t.low[next], t.high[next]);
        sum += rna_bilinear(plane, group, columns, rows, t.fraction[plane], t.fraction[next]);
    }
    return sum;
}
`,"render/bumps.wgsl":`// Normals of materials with the relief of a normal texture: rna_render/materials/bumps.py.

const MIN_MIRROR_COSINE: f32 = 0.01;

fn unit_or_zero(v: vec3f) -> vec3f {
    let size = length(v);
    return select(vec3f(0.0), v / max(size, 1e-30), size > 0.0);
}

fn point_tangent(base: u32, point: u32) -> vec4f {
    let at = base + 4u * point;
    return bitcast<vec4f>(vec4<u32>(images[at], images[at + 1u], images[at + 2u], images[at + 3u]));
}

// The file's tangent, interpolated, and the bitangent's sign; a sign of 0 where a corner has none.
fn given_tangent(record: RnaPrimitive, b: vec3f) -> vec4f {
    let base = surface_tangents(rna_surface(record));
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.a);
    let second = point_tangent(base, record.b);
    let third = point_tangent(base, record.c);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: RnaPrimitive, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = select(1.0, -1.0, area < 0.0);
    let along_u = side * (d2.y * e1 - d1.y * e2);
    let along_v = side * (d1.x * e2 - d2.x * e1);
    let sign = select(1.0, -1.0, dot(cross(n, along_u), along_v) > 0.0);
    return vec4f(along_u, select(0.0, sign, area != 0.0));
}

// m, or the nearest normal that mirrors o above the surface; g is on o's side.
fn raised_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: RnaPrimitive, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(rna_surface(record), RELIEF);
    if texture == NONE {
        return m;
    }
    let uvs = corner_uvs(record, (image_of(texture).form >> 5u) & 1u);
    let b = weights_of(b1, b2);
    var tangent = given_tangent(record, b);
    if tangent.w == 0.0 {
        tangent = derived_tangent(record, uvs, m);
    }
    let t = unit_or_zero(tangent.xyz - dot(tangent.xyz, m) * m);
    if tangent.w == 0.0 || dot(t, t) == 0.0 {
        return m;
    }
    let scale = surface_normal_scale(rna_surface(record));
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let own = select(-side, side, dot(m, g) >= 0.0);
    return own * raised_above(own * bent, side * g, o);
}
`,"render/directions.wgsl":`// Directions about an axis.

const SPHERE_PDF: f32 = 1.0 / (4.0 * PI);

struct Tangents {
    s: vec3f,
    t: vec3f,
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
fn tangents_of(n: vec3f) -> Tangents {
    let sign = select(1.0, -1.0, n.z < 0.0);
    let c = -1.0 / (sign + n.z);
    let d = n.x * n.y * c;
    return Tangents(
        vec3f(1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x),
        vec3f(d, sign + n.y * n.y * c, -n.y),
    );
}

fn about(axis: vec3f, sine: f32, cosine: f32, turns: f32) -> vec3f {
    let frame_of = tangents_of(axis);
    let phi = 2.0 * PI * turns;
    return sine * cos(phi) * frame_of.s + sine * sin(phi) * frame_of.t + cosine * axis;
}

fn along_axis(axis: vec3f, cosine: f32, turns: f32) -> vec3f {
    return about(axis, sqrt(max(0.0, 1.0 - cosine * cosine)), cosine, turns);
}

// Cosine to the axis of a von Mises-Fisher direction.
fn fisher_cosine(u: f32, kappa: f32) -> f32 {
    return max(-1.0, 1.0 + log(u + (1.0 - u) * exp(-2.0 * kappa)) / kappa);
}

fn fisher_pdf(cosine: f32, kappa: f32) -> f32 {
    return kappa * exp(kappa * (cosine - 1.0)) / (2.0 * PI * (1.0 - exp(-2.0 * kappa)));
}

// Uniform within a cone about a unit axis, by 1 - cos of the angle to its rim.
fn cone_direction(axis: vec3f, one_minus_cosine: f32, u: vec2f) -> vec3f {
    let height = u.x * one_minus_cosine;
    return about(axis, sqrt(max(0.0, height * (2.0 - height))), 1.0 - height, u.y);
}
`,"render/environment.wgsl":`// An equirectangular image: see rna_render/lights/equirectangular.py and image_kernels.py, which this follows. In \`images\`
// a light has texels (h, w, 3), heights (h + 1), running sums of rows (h + 2) and of each row's cells
// (h + 1, w + 1).

struct Cell {
    corners: mat4x3f,
    luminances: vec4f,
}

fn image_float(at: u32) -> f32 {
    return bitcast<f32>(images[at]);
}

fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

fn image_size(light: u32) -> vec2<u32> {
    return vec2<u32>(u32(image_rows(light)), u32(image_columns(light)));
}

fn image_texel(light: u32, row: u32, column: u32) -> vec3f {
    let at = image_texels(light) + 3u * (row * image_size(light).y + column);
    return vec3f(image_float(at), image_float(at + 1u), image_float(at + 2u));
}

fn image_cell(light: u32, row: u32, column: u32) -> Cell {
    let size = image_size(light);
    let upper = max(row, 1u) - 1u;
    let lower = min(row, size.x - 1u);
    let right = select(0u, column + 1u, column + 1u < size.y);
    let a = image_texel(light, upper, column);
    let b = image_texel(light, upper, right);
    let c = image_texel(light, lower, column);
    let d = image_texel(light, lower, right);
    return Cell(
        mat4x3f(a, b, c, d), vec4f(luminance(a), luminance(b), luminance(c), luminance(d)),
    );
}

fn in_cell(cell: Cell, x: f32, y: f32) -> vec3f {
    return cell.corners * vec4f((1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y);
}

// The interval of running sums from \`at\` on, \`count\` of them, that a value is in, by bisection.
fn interval(at: u32, count: u32, value: f32) -> u32 {
    var low = 0u;
    var high = count;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if image_float(at + middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn place_within(at: u32, k: u32, value: f32) -> f32 {
    let size = image_float(at + k + 1u) - image_float(at + k);
    if size <= 0.0 {
        return 0.0;
    }
    return clamp((value - image_float(at + k)) / size, 0.0, 0.99999994);
}

// A place in [0, 1] with density in proportion to a line from a to b.
fn sample_linear(a: f32, b: f32, u: f32) -> f32 {
    let root = sqrt(max(a * a + u * (b * b - a * a), 0.0));
    if a + root <= 0.0 {
        return u;
    }
    return u * (a + b) / (a + root);
}

fn image_density(light: u32, row: u32, sine: f32, here: f32, mean_here: f32) -> f32 {
    let total = image_total(light);
    let mean = image_mean(light);
    if total <= 0.0 {
        return 0.0;
    }
    let size = image_size(light);
    var pdf = here * f32(size.y) / (2.0 * PI * total);
    if mean > 0.0 {
        pdf *= max(mean_here - mean, 0.0) / max(mean_here, 1e-30);
    }
    if row > 0u && row < size.x {
        let height = image_float(image_heights(light) + row);
        pdf *= height * f32(size.x) / (PI * max(sine, 1e-30));
    }
    return pdf;
}

// Where in a cell of that row, down from the middles above.
fn sample_down(light: u32, row: u32, l: vec4f, u: f32) -> f32 {
    let h = image_size(light).x;
    let height = image_float(image_heights(light) + row);
    let cap = 2.0 * asin(sqrt(u * height / 2.0)) / PI * f32(h);
    if row == 0u {
        return cap + 0.5;
    }
    if row == h {
        return 0.5 - cap;
    }
    return sample_linear(l.x + l.y, l.z + l.w, u);
}

fn sample_image(light: u32, u: vec2f) -> LightSample {
    let size = image_size(light);
    let rows = image_row_sums(light);
    let down = u.y * image_float(rows + size.x + 1u);
    let row = interval(rows, size.x + 1u, down);
    let columns = image_column_sums(light) + row * (size.y + 1u);
    let across = u.x * image_float(columns + size.y);
    let column = interval(columns, size.y, across);
    let cell = image_cell(light, row, column);
    let l = cell.luminances;
    let y = sample_down(light, row, l, place_within(rows, row, down));
    let left = mix(l.x, l.z, y);
    let x = sample_linear(left, mix(l.y, l.w, y), place_within(columns, column, across));
    let theta = PI * (f32(row) - 0.5 + y) / f32(size.x);
    let phi = 2.0 * PI * ((f32(column) + 0.5 + x) / f32(size.y) - 0.5);
    let sine = sin(theta);
    let away = sine * sin(phi);
    let along = -sine * cos(phi);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let wi = vec3f(turn.x * away + turn.y * along, cos(theta), turn.x * along - turn.y * away);
    let radiance = in_cell(cell, x, y);
    let pdf = image_density(light, row, sine, luminance(radiance), dot(l, vec4f(0.25)));
    return light_sample(wi, RNA_FAR, light_colour(light) * radiance, pdf);
}

fn look_up_image(light: u32, d: vec3f) -> LightHit {
    let size = image_size(light);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let x = turn.x * d.x - turn.y * d.z;
    let z = turn.y * d.x + turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    var azimuth = 0.0;
    if sine > 0.0 {
        azimuth = atan2(x, -z);
    }
    let s = (0.5 + azimuth / (2.0 * PI)) * f32(size.y) - 0.5;
    let t = atan2(sine, d.y) / PI * f32(size.x) + 0.5;
    let row = u32(clamp(floor(t), 0.0, f32(size.x)));
    let left = floor(s);
    let column = select(size.y - 1u, u32(max(left, 0.0)), left >= 0.0 && left < f32(size.y));
    let cell = image_cell(light, row, column);
    let radiance = in_cell(cell, s - left, t - f32(row));
    let mean = dot(cell.luminances, vec4f(0.25));
    let pdf = image_density(light, row, sine, luminance(radiance), mean);
    return LightHit(light_colour(light) * radiance, pdf);
}
`,"render/frame.wgsl":`// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> queries: array<PathQueries>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY] += vec4f(radiance, 0.0);
    let group = light_group(light);
    if group != NONE {
        sums[at + SUM_GROUPS + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Clamped after two or more scatterings.
fn clamped(radiance: vec3f) -> vec3f {
    if frame.clamp <= 0.0 || frame.depth < 2u {
        return radiance;
    }
    let largest = max(max(radiance.x, max(radiance.y, radiance.z)), 1e-30);
    return radiance * (min(frame.clamp, largest) / largest);
}

// Power heuristic: the part of the estimate that belongs to the first way.
fn share(pdf: f32, other: f32) -> f32 {
    if pdf <= 0.0 {
        return 0.0;
    }
    let ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
`,"render/light_shapes.wgsl":`// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    var hit = found;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = frame.rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
        let t = meet_light(light, RnaRay(ray.origin, ray.near, ray.direction, hit.t));
        if !hidden && t < RNA_FAR && (hit.instance == RNA_NOTHING || t < hit.t) {
            hit = rna_miss(t);
            hit.instance = IS_LIGHT | light;
        }
    }
    return hit;
}
`,"render/lights.wgsl":`// Lights: samples of them, and their radiance and density at hits of rays. They are those of rna_render.lights.

const MAX_PDF: f32 = 1e18;
const MIN_SOLID_ANGLE: f32 = 1e-3; // float32 knows no smaller one to 1e-3 of itself

struct LightSample {
    wi: vec3f,
    distance: f32,
    radiance: vec3f, // of an asset's triangles a factor on what they emit
    pdf: f32,
    primitive: u32, // of triangles
    b1: f32,
    b2: f32,
}

fn light_sample(wi: vec3f, distance: f32, radiance: vec3f, pdf: f32) -> LightSample {
    return LightSample(wi, distance, radiance, pdf, NONE, 0.0, 0.0);
}

// A light along a ray: its radiance, and the density of sampling it there.
struct LightHit {
    radiance: vec3f,
    pdf: f32,
}

// Samples that a light gets at a point, on average.
fn samples_of(light: u32, depth: u32) -> f32 {
    return light_probability(light)[min(depth, 3u) - 1u];
}

fn light_is(light: u32, flag: u32) -> bool {
    return (light_flags(light) & flag) != 0u;
}

// Of points of a plane: per_area, seen along d; 0 from behind.
fn flat_pdf(point: vec3f, normal: vec3f, per_area: f32, x: vec3f, d: vec3f) -> f32 {
    let cosine = -dot(d, normal);
    let height = dot(x - point, normal);
    if cosine <= 0.0 || height <= 0.0 {
        return 0.0;
    }
    let t = height / cosine;
    let pdf = per_area * t * t / cosine;
    return select(0.0, pdf, pdf < MAX_PDF);
}

fn edge_angle(x: f32, y: f32, sign: f32, height: f32) -> f32 {
    return atan2(height * sqrt(x * x + y * y + height * height), sign * x * y);
}

// Solid angle of a rectangle from (x0, y0) to (x1, y1), and the sum k of Ure\xF1a, Fajardo and King,
// An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013), section 5.
fn solid_angle(e: vec4f, height: f32) -> vec2f {
    let k = 2.0 * PI - edge_angle(e.x, e.w, 1.0, height) - edge_angle(e.x, e.z, -1.0, height);
    let right = edge_angle(e.y, e.z, 1.0, height) + edge_angle(e.y, e.w, -1.0, height);
    return vec2f(right - k, k);
}

// Edges x0, x1, y0, y1 of a rectangle as seen from x.
fn rectangle_edges(light: u32, from_place: vec3f) -> vec4f {
    let a = dot(from_place, rectangle_frame(light)[0]);
    let b = dot(from_place, rectangle_frame(light)[1]);
    let half = rectangle_half(light);
    return vec4f(-half.x - a, half.x - a, -half.y - b, half.y - b);
}

fn rectangle_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let half = rectangle_half(light);
    let f = rectangle_frame(light);
    let flat = flat_pdf(f[3], f[2], 0.25 / (half.x * half.y), x, d);
    let height = dot(x - f[3], f[2]);
    let angle = solid_angle(rectangle_edges(light, x - f[3]), max(height, 1e-30)).x;
    if flat == 0.0 || angle < MIN_SOLID_ANGLE {
        return flat;
    }
    return 1.0 / angle;
}

fn rectangle_point(e: vec4f, height: f32, u: vec2f) -> vec2f {
    let angle = solid_angle(e, height);
    if angle.x < MIN_SOLID_ANGLE {
        return mix(e.xz, e.yw, u);
    }
    let b0 = -e.z / sqrt(height * height + e.z * e.z);
    let b1 = e.w / sqrt(height * height + e.w * e.w);
    let turn = u.x * angle.x + angle.y;
    let sine = sin(turn);
    let f = (cos(turn) * b0 - b1) / select(sine, 1e-20, abs(sine) < 1e-20);
    let c = clamp(select(-1.0, 1.0, f >= 0.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    let x = clamp(c * height / sqrt(max(1.0 - c * c, 1e-20)), e.x, e.y);
    let squared = x * x + height * height;
    let h0 = e.z / sqrt(squared + e.z * e.z);
    let h1 = e.w / sqrt(squared + e.w * e.w);
    let h = h0 + u.y * (h1 - h0);
    let y = h * sqrt(squared / max(1.0 - h * h, 1e-20));
    return vec2f(x, clamp(y, e.z, e.w));
}

// Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
fn concentric(u: vec2f) -> vec2f {
    let a = 2.0 * u - 1.0;
    if a.x == 0.0 && a.y == 0.0 {
        return vec2f(0.0);
    }
    if abs(a.x) > abs(a.y) {
        let phi = PI / 4.0 * (a.y / a.x);
        return a.x * vec2f(cos(phi), sin(phi));
    }
    let phi = PI / 2.0 - PI / 4.0 * (a.x / a.y);
    return a.y * vec2f(cos(phi), sin(phi));
}

// 1 - cos of the angular radius of a sphere light; 0 from within.
fn sphere_cone(light: u32, x: vec3f) -> f32 {
    let to_centre = sphere_centre(light) - x;
    let radius = sphere_radius(light);
    let squared = dot(to_centre, to_centre);
    if squared <= radius * radius {
        return 0.0;
    }
    let sin2 = radius * radius / squared;
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}

fn shape_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        return rectangle_pdf(light, x, d);
    }
    if kind == DISK {
        let radius = disk_radius(light);
        let per_area = 1.0 / (PI * radius * radius);
        return flat_pdf(disk_frame(light)[3], disk_frame(light)[2], per_area, x, d);
    }
    let cone = sphere_cone(light, x);
    return select(0.0, 1.0 / (2.0 * PI * max(cone, 1e-18)), cone > 0.0);
}

// A point of a shape, relative to x.
fn shape_point(light: u32, x: vec3f, u: vec2f) -> vec3f {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        let f = rectangle_frame(light);
        let height = dot(x - f[3], f[2]);
        if height <= 0.0 {
            return f[3] - x;
        }
        let p = rectangle_point(rectangle_edges(light, x - f[3]), height, u);
        return p.x * f[0] + p.y * f[1] - height * f[2];
    }
    if kind == DISK {
        let f = disk_frame(light);
        let p = disk_radius(light) * concentric(u);
        return f[3] + p.x * f[0] + p.y * f[1] - x;
    }
    let to_centre = sphere_centre(light) - x;
    let wi = cone_direction(normalize(to_centre), sphere_cone(light, x), u);
    let along = dot(to_centre, wi);
    let rest = to_centre - along * wi;
    let radius = sphere_radius(light);
    return (along - sqrt(max(0.0, radius * radius - dot(rest, rest)))) * wi;
}

fn sample_point(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, light_colour(light) / (r * r), 1.0);
}

fn sample_spot(light: u32, x: vec3f) -> LightSample {
    let way = spot_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, spot_axis(light));
    let inner = spot_cos_inner(light);
    let outer = spot_cos_outer(light);
    var factor = 1.0;
    if cosine < inner {
        let t = clamp((cosine - outer) / max(inner - outer, 1e-20), 0.0, 1.0);
        factor = t * t * (3.0 - 2.0 * t);
    }
    let pdf = select(0.0, 1.0, factor > 0.0);
    return light_sample(wi, r, factor / (r * r) * light_colour(light), pdf);
}

fn sample_light(light: u32, x: vec3f, u: vec2f) -> LightSample {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return sample_image(light, u);
    }
    if kind == UNIFORM {
        return light_sample(
            cone_direction(vec3f(0.0, 0.0, 1.0), 2.0, u), RNA_FAR, colour, SPHERE_PDF,
        );
    }
    if kind == SUN {
        let cone = sun_one_minus_cosine(light);
        let wi = cone_direction(sun_axis(light), cone, u);
        return light_sample(wi, RNA_FAR, colour, 1.0 / (2.0 * PI * cone));
    }
    if kind == DIRECTIONAL {
        return light_sample(directional_axis(light), RNA_FAR, colour, 1.0);
    }
    if kind == TRIANGLES {
        return sample_triangles(light, x, u);
    }
    if kind == POINT {
        return sample_point(light, x);
    }
    if kind == SPOT {
        return sample_spot(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// An infinite light along d.
fn environment_along(light: u32, d: vec3f) -> LightHit {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return LightHit(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return LightHit(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return LightHit(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's position there, along the light's axes.
fn on_plane(f: mat4x3f, ray: RnaRay, t: f32) -> vec2f {
    let p = ray.origin + t * ray.direction - f[3];
    return vec2f(dot(p, f[0]), dot(p, f[1]));
}

// Where a ray meets the shape of a light; RNA_FAR where it does not.
fn meet_light(light: u32, ray: RnaRay) -> f32 {
    let kind = light_kind(light);
    var t = RNA_FAR;
    if kind == SPHERE {
        let centre = sphere_centre(light);
        let radius = sphere_radius(light);
        t = rna_enter_sphere(ray.origin, ray.direction, centre, radius);
        let from_centre = ray.origin - centre;
        if dot(from_centre, from_centre) < radius * radius && t < RNA_FAR {
            t = -t - 2.0 * dot(from_centre, ray.direction);
        }
    } else if kind == RECTANGLE {
        let f = rectangle_frame(light);
        t = meet_plane(f, ray);
        let p = abs(on_plane(f, ray, t));
        t = select(RNA_FAR, t, all(p <= rectangle_half(light)));
    } else if kind == DISK {
        let f = disk_frame(light);
        t = meet_plane(f, ray);
        t = select(RNA_FAR, t, length(on_plane(f, ray, t)) <= disk_radius(light));
    }
    return select(RNA_FAR, t, t >= ray.near && t < ray.far);
}
`,"render/lobe_constants.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const SURFACE_SHARES = vec3f(0.2, 0.35, 0.45);
const FIBER_SHARES = vec3f(0.3, 0.45, 0.25);
const MIRROR_KAPPA: f32 = 20.0;
const CONE_SCALE: f32 = 0.06;
const FORWARD_KAPPA: f32 = 5.0;
`,"render/passing.wgsl":`// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed

var<private> passing: u32;
var<private> passed_weight: vec3f;
var<private> is_coloured: bool;
var<private> stopped_share: vec3f; // of the last hit that stopped: what colours it leaves
var<private> chance_key: u32;

fn start_passing(how: u32) {
    passing = select(ALL_STOP, how, (frame.flags & TRANSMITS) != 0u);
    passed_weight = vec3f(1.0);
    is_coloured = false;
}

// In [0, 1), a fixed number for each primitive and ray.
fn chance(primitive: u32, instance: u32) -> f32 {
    let state = hash_bits(hash_bits(chance_key ^ primitive) + instance);
    return f32(state >> 8u) * 0x1p-24f;
}

fn pass_at_random(tau: vec3f, mean: f32, passes: bool) -> bool {
    let coloured = any(tau != vec3f(tau.x));
    if passes {
        is_coloured = is_coloured || coloured;
        return false;
    }
    stopped_share = select(vec3f(1.0), (1.0 - tau) / max(1.0 - mean, 1e-6), coloured);
    return true;
}

fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool {
    stopped_share = vec3f(1.0);
    if passing == ALL_STOP {
        return true;
    }
    let record = rna_primitives[primitive];
    if !surface_has(rna_surface(record), LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.a].xyz;
    let ng = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let facing = dot(ng, ray.direction) < 0.0;
    let tau = transmittance(record, found.y, found.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
    let passes = mean > 0.0 && chance(primitive, instance) < mean;
    if passing == AT_RANDOM {
        return pass_at_random(tau, mean, passes);
    }
    if passes {
        passed_weight *= tau / mean;
    }
    return false;
}
`,"render/sampler.wgsl":`// Owen-scrambled Sobol' points, the very ones of rna_render.paths.sampling: a pure function of seed, pixel,
// sample and dimension.

fn hash_bits(value: u32) -> u32 {
    var x = (value ^ (value >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
fn owen(value: u32, seed: u32) -> u32 {
    var x = reverseBits(value) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

fn second_sobol(index: u32) -> u32 {
    var x = reverseBits(index);
    x ^= x << 16u;
    x ^= (x & 0x00ff00ffu) << 8u;
    x ^= (x & 0x0f0f0f0fu) << 4u;
    x ^= (x & 0x33333333u) << 2u;
    return x ^ ((x & 0x55555555u) << 1u);
}

// A point of the unit square for a dimension of the path at its present point.
fn square(pixel: u32, dimension: u32, number: u32) -> vec2f {
    let image_key = hash_bits(hash_bits(frame.seed) + dimension);
    let key = hash_bits(image_key ^ hash_bits(pixel + 1u));
    let index = owen(number, key);
    let first = owen(reverseBits(index), hash_bits(key + 1u));
    let second = owen(second_sobol(index), hash_bits(key + 2u));
    return vec2f(f32(first >> 8u), f32(second >> 8u)) * 0x1p-24f;
}

// Number of the path among all of its pixel that have come to this point.
fn path_of_pixel() -> u32 {
    return frame.sample * frame.branches + frame.branch;
}

fn at_point(pixel: u32, dimension: u32) -> vec2f {
    return square(pixel, (frame.depth - 1u) * DIMENSIONS + dimension, path_of_pixel());
}

// What a path's next ray passes at random through.
fn chance_of(pixel: u32) -> u32 {
    let path = hash_bits(hash_bits(frame.seed + 1u) ^ hash_bits(pixel + 1u));
    return hash_bits(hash_bits(path ^ path_of_pixel()) + frame.depth);
}
`,"render/scene_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const NONE: u32 = 0xffffffffu;
const SUM_BEAUTY: u32 = 0u;
const SUM_NORMAL: u32 = 1u;
const SUM_POSITION: u32 = 2u;
const SUM_LIGHT_SAMPLES: u32 = 3u;
const SUM_BEHIND: u32 = 4u;
const IS_LIGHT: u32 = 0x80000000u;
const MATERIAL_PART: u32 = 0xfffffffeu;
const CATCHER_PART: u32 = 0xfffffffdu;
const SUM_GROUPS: u32 = 5u;
const CAMERA_RAY: u32 = 1u;
const SHADOW_RAY: u32 = 4u;
const ALL_DIRECTIONS: u32 = 0xffffffffu;
const HEMISPHERE: u32 = 0xfffffffeu;
const CHOICES: u32 = 1u;
const DIRECTION: u32 = 2u;
const ROULETTE: u32 = 3u;
const LIGHT: u32 = 4u;
const DIMENSIONS: u32 = 7u;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u;

struct Frame { // 160 bytes
    camera: vec3f, // 0
    width: u32, // 12
    corner: vec3f, // 16; direction through the image's top left corner
    paths: u32, // 28
    step_x: vec3f, // 32; of a pixel
    sample: u32, // 44
    step_y: vec3f, // 48
    seed: u32, // 60
    depth: u32, // 64; points of the path so far
    light: u32, // 68; that is sampled; NONE: one that is chosen
    part: u32, // 72; number of the sample of this light at this point
    parts: u32, // 76; samples of this light at this point
    rays: u32, // 80; bit of the sort of rays
    clamp: f32, // 84
    light_count: u32, // 88
    sums: u32, // 92; vec4f of a path in \`sums\`: SUM_GROUPS, and two a group of lights
    flags: u32, // 96; of those below
    branch: u32, // 100; number of the ray that went on from the first point
    branches: u32, // 104; of those rays; 1 before them
    neural_part: u32, // 108
    list: u32, // 112; start in \`live\` of the list of paths that the step is for
    next_list: u32, // 116; likewise, of those that go on from there
    table_size: u32, // 120; of albedo
    objects: u32, // 124; this and the rest: starts of the sections of \`table\`
    surfaces: u32, // 128
    lights: u32, // 132
    albedo: u32, // 136
    domains: u32, // 140
    textures: u32, // 144
}

struct Path { // 96 bytes
    origin: vec3f, // 0
    pixel: u32, // 12
    direction: vec3f, // 16
    pdf: f32, // 28; of the direction; 0 of camera rays
    beta: vec3f, // 32
    state: u32, // 44
    normal: vec3f, // 48; of a segment
    t: f32, // 60
    instance: u32, // 64
    primitive: u32, // 68
    own: u32, // 72; instance that the ray passes through
    b1: f32, // 76
    leaving: vec3f, // 80; of a ray that leaves an asset: its start in object space
    b2: f32, // 92
}

struct Query { // 96 bytes
    x: vec3f, // 0
    h: f32, // 12
    axis: vec3f, // 16
    part: u32, // 28; whose decoder answers, or NONE, MATERIAL_PART, CATCHER_PART
    wo: vec3f, // 32
    light: u32, // 44
    wi: vec3f, // 48
    strand: u32, // 60; that a ray from here passes through
    weight: vec3f, // 64
    seen: f32, // 76; mean of what all that is in the way leaves of the light
    visible: vec3f, // 80; what the asset itself leaves of it
    reserved: u32, // 92
}

struct PathQueries { // 192 bytes
    at_point: Query, // 0; what the path's point scatters or emits
    at_light: Query, // 96; what an asset emits at its point that was sampled as a light
}
`,"render/surfaces.wgsl":`// Surfaces of the scene, by the number that primitives have; scene_surfaces.py fills them.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

fn surface_has(surface: u32, flag: u32) -> bool {
    return (surface_flags(surface) & flag) != 0u;
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = surface_second_uvs(surface) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: RnaPrimitive, uv_set: u32) -> mat3x2f {
    let surface = rna_surface(record);
    return mat3x2f(
        corner_uv(surface, record.a, uv_set),
        corner_uv(surface, record.b, uv_set),
        corner_uv(surface, record.c, uv_set),
    );
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
`,"render/table_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const OF_MATERIAL: u32 = 0u;
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;
const EMITS: u32 = 1u;
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u;
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;
const BASE: u32 = 0u;
const METAL: u32 = 1u;
const COAT: u32 = 2u;
const GLOW: u32 = 3u;
const CLEAR: u32 = 4u;
const CLEAR_ROUGH: u32 = 5u;
const THROUGH: u32 = 6u;
const RELIEF: u32 = 7u;
const LIGHT_SEEN: u32 = 1u;
const LIGHT_DELTA: u32 = 2u;
const LIGHT_INFINITE: u32 = 4u;
const DIRECTIONAL: u32 = 0u;
const DISK: u32 = 1u;
const IMAGE: u32 = 2u;
const POINT: u32 = 3u;
const RECTANGLE: u32 = 4u;
const SPHERE: u32 = 5u;
const SPOT: u32 = 6u;
const SUN: u32 = 7u;
const TRIANGLES: u32 = 8u;
const UNIFORM: u32 = 9u;

fn object_number(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].x;
}
fn object_catches(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].y);
}
fn object_step(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].z;
}
fn object_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].w);
}

fn surface_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].x);
}
fn surface_part(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].y);
}
fn surface_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].z);
}
fn surface_normal_map(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].w);
}
fn surface_base_color(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 1u].xyz;
}
fn surface_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 1u].w;
}
fn surface_metallic(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].x;
}
fn surface_coat_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].y;
}
fn surface_coat_weight(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].z;
}
fn surface_transmission(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].w;
}
fn surface_emission(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 3u].xyz;
}
fn surface_normal_scale(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 3u].w;
}
fn surface_clear_coat(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].x;
}
fn surface_clear_coat_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].y;
}
fn surface_second_uvs(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].z);
}
fn surface_tangents(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].w);
}
fn surface_textures(k: u32, i: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 5u + i / 4u][i % 4u]);
}
fn surface_through(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 7u].x);
}
fn surface_cutoff(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 7u].y;
}
fn surface_ior(k: u32) -> vec2f {
    return table[frame.surfaces + 9u * k + 7u].zw;
}
fn surface_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 8u].x;
}

fn texture_place(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].x);
}
fn texture_size(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].y);
}
fn texture_form(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].z);
}
fn texture_row_u(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 1u].xyz;
}
fn texture_row_v(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 2u].xyz;
}

fn light_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].x);
}
fn light_group(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].y);
}
fn light_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].z);
}
fn light_instance(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].w);
}
fn light_numbers(k: u32, i: u32) -> f32 {
    return table[frame.lights + 8u * k + 1u + i / 4u][i % 4u];
}
fn light_probability(k: u32) -> vec3f {
    return table[frame.lights + 8u * k + 6u].xyz;
}
fn light_places(k: u32) -> vec4<u32> {
    return bitcast<vec4<u32>>(table[frame.lights + 8u * k + 7u].xyzw);
}

fn light_colour(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 0u), light_numbers(k, 1u), light_numbers(k, 2u));
}
fn directional_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn disk_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn disk_radius(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_turn_cosine(k: u32) -> f32 {
    return light_numbers(k, 3u);
}
fn image_turn_sine(k: u32) -> f32 {
    return light_numbers(k, 4u);
}
fn image_total(k: u32) -> f32 {
    return light_numbers(k, 5u);
}
fn image_mean(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_rows(k: u32) -> f32 {
    return light_numbers(k, 7u);
}
fn image_columns(k: u32) -> f32 {
    return light_numbers(k, 8u);
}
fn point_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn rectangle_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn rectangle_half(k: u32) -> vec2f {
    return vec2f(light_numbers(k, 15u), light_numbers(k, 16u));
}
fn sphere_centre(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sphere_radius(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn spot_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn spot_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 6u), light_numbers(k, 7u), light_numbers(k, 8u));
}
fn spot_cos_inner(k: u32) -> f32 {
    return light_numbers(k, 9u);
}
fn spot_cos_outer(k: u32) -> f32 {
    return light_numbers(k, 10u);
}
fn sun_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_one_minus_cosine(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn triangles_rotation(k: u32) -> mat3x3f {
    return mat3x3f(light_numbers(k, 3u), light_numbers(k, 6u), light_numbers(k, 9u), light_numbers(k, 4u), light_numbers(k, 7u), light_numbers(k, 10u), light_numbers(k, 5u), light_numbers(k, 8u), light_numbers(k, 11u));
}
fn triangles_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 12u), light_numbers(k, 13u), light_numbers(k, 14u));
}
fn triangles_scale(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_texels(k: u32) -> u32 {
    return light_places(k).x;
}
fn image_heights(k: u32) -> u32 {
    return light_places(k).y;
}
fn image_row_sums(k: u32) -> u32 {
    return light_places(k).z;
}
fn image_column_sums(k: u32) -> u32 {
    return light_places(k).w;
}
fn triangles_sums(k: u32) -> u32 {
    return light_places(k).x;
}
fn triangles_primitives(k: u32) -> u32 {
    return light_places(k).y;
}
fn triangles_densities(k: u32) -> u32 {
    return light_places(k).z;
}
fn triangles_count(k: u32) -> u32 {
    return light_places(k).w;
}
`,"render/textures.wgsl":`// Textures on triangles: rna_render/materials/textures.py. A texel is a u32 of three bytes.

const REPEAT: u32 = 0u;
const MIRROR: u32 = 2u;

struct Image {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32,
}

fn image_of(texture: u32) -> Image {
    let size = texture_size(texture);
    return Image(
        texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture),
    );
}

fn texel(at: Image, column: u32, row: u32) -> vec3f {
    let word = images[at.place + row * at.size.x + column];
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & 16u) == 0u {
        return c;
    }
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct Around {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn texels_around(x: f32, size: u32, wrap: u32) -> Around {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == REPEAT {
        inside = x - floor(x);
    } else if wrap == MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == REPEAT {
        let wrapped = select(first, last, first < 0);
        return Around(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return Around(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, mixed after decoding, at the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    let at = image_of(texture);
    let u = dot(texture_row_u(texture), vec3f(uv, 1.0));
    let v = dot(texture_row_v(texture), vec3f(uv, 1.0));
    let x = texels_around(u, at.size.x, at.form & 3u);
    let y = texels_around(v, at.size.y, (at.form >> 2u) & 3u);
    let upper = mix(texel(at, x.first, y.first), texel(at, x.second, y.first), x.part);
    let lower = mix(texel(at, x.first, y.second), texel(at, x.second, y.second), x.part);
    return mix(upper, lower, y.part);
}

// On a triangle at barycentrics.
fn texture_on(texture: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    return surface_emission(rna_surface(record)) * factor_on(GLOW, record, b1, b2);
}
`,"render/tracing.wgsl":`// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray; \`key\` decides what it passes.
fn closest_through(ray: RnaRay, own: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let found = rna_trace(line, own, frame.rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, found);
        let is_triangle = (hit.instance & IS_LIGHT) == 0u
            && !rna_is_segment(rna_primitives[hit.primitive]);
        share = select(share, stopped_share, is_triangle);
        if !is_coloured {
            break;
        }
        passing = WEIGH;
        line.far = hit.t;
    }
    return Through(hit, share * passed_weight);
}

// What a shadow ray keeps of its light.
fn visible_on(ray: RnaRay, own: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, own, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn start_visibility(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
    var hit = rna_miss(ray.far);
    let root = rna_instances[instance].root;
    start_passing(WEAKEN);
    let stopped = rna_trace_body(root, ray, strand, true, &hit);
    return select(passed_weight, vec3f(0.0), stopped);
}
`,"render/transmittance.wgsl":`// What triangles let through, of materials and of assets: spec/RNA.md, 4.4 Transmittance, and
// rna_trace/transmittance.py.

// Unpolarised, of an interface of relative index eta.
fn dielectric_reflectance(eta: f32, cosine: f32) -> f32 {
    let squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if squared <= 0.0 {
        return 1.0;
    }
    let root = sqrt(squared);
    let s = (cosine - eta * root) / (cosine + eta * root);
    let p = (eta * cosine - root) / (eta * cosine + root);
    return 0.5 * (s * s + p * p);
}

// The part that a smooth interface does not reflect of a ray along d, in object space.
fn passed_interface(
    record: RnaPrimitive, b: vec3f, d: vec3f, facing: bool,
) -> f32 {
    let surface = rna_surface(record);
    let ior = surface_ior(surface);
    let eta = select(ior.y, ior.x, facing);
    let schlick = surface_has(surface, HAS_SCHLICK);
    if eta == 0.0 && !schlick {
        return 1.0;
    }
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz) * b;
    let cosine = min(abs(dot(n, d)) / max(sqrt(dot(n, n) * dot(d, d)), 1e-30), 1.0);
    if eta != 0.0 {
        return 1.0 - dielectric_reflectance(eta, cosine);
    }
    let f0 = surface_f0(surface);
    let away = 1.0 - cosine;
    return (1.0 - f0) * (1.0 - away * away * away * away * away);
}

// Of a triangle, for a ray along d in object space. facing: it meets the normal's side.
fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    let surface = rna_surface(record);
    if !surface_has(surface, LETS_THROUGH) {
        return vec3f(0.0);
    }
    var tau = texture_on(surface_through(surface), record, b1, b2);
    if surface_has(surface, HAS_CUTOFF) {
        tau = select(vec3f(0.0), vec3f(1.0), tau > vec3f(surface_cutoff(surface)));
    }
    let passed = passed_interface(record, weights_of(b1, b2), d, facing);
    return min(tau * passed, vec3f(1.0));
}
`,"render/triangle_lights.wgsl":`// Triangles that shine, of an object or an asset: rna_render/lights/kinds/mesh.py. In \`images\` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let area = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let sums_at = triangles_sums(light);
    let count = triangles_count(light);
    if count == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(sums_at + count);
    let chosen = interval(sums_at, count, value);
    let root = sqrt(place_within(sums_at, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[triangles_primitives(light) + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let way = p - x + b.x * (rna_points[record.b].xyz - p) + b.y * (rna_points[record.c].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[instance].scale;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_colour(light);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
`,"render/vertex.wgsl":`// The point that a path has come to, from its hit.

struct Vertex {
    x: vec3f, // object space, as all that is not said otherwise
    kind: u32,
    n: vec3f, // interpolated normal, or that of a segment
    surface: u32,
    ng: vec3f,
    part: u32,
    lift: vec3f,
    h: f32,
    axis: vec3f, // of a decoder's queries: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: RnaPrimitive, // of its primitive
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: RnaPrimitive, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
    );
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz);
    v.x = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
    let mixed = n * b;
    v.n = select(vec3f(0.0), mixed / max(length(mixed), 1e-30), dot(mixed, mixed) > 0.0);
    let area = cross(p[1] - p[0], p[2] - p[0]);
    let largest = max(abs(area.x), max(abs(area.y), abs(area.z)));
    if largest > 0.0 {
        v.ng = normalize(area / largest);
    }
    v.lift = rna_lift(v.x, b, p, n);
    v.shading = v.n;
    v.b1 = b1;
    v.b2 = b2;
    let map = surface_normal_map(rna_surface(record));
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

fn segment_vertex(path: Path, record: RnaPrimitive, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = path.normal;
    v.ng = path.normal;
    v.x = path.t * rna_object_direction(path.direction, path.instance)
        / rna_instances[path.instance].scale
        + rna_object_point(path.origin, path.instance);
    v.x = on_cone(cone, v.x, v.n);
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// The point of the surface of normal n near x: that of the sphere which touches it there. The error
// of x is that of its ray's length.
fn on_cone(cone: RnaCone, x: vec3f, n: vec3f) -> vec3f {
    let way = cone.b - cone.a;
    let radius = dot(x - cone.a, n);
    let along = dot(x - cone.a - clamp(radius, 0.0, max(cone.ra, cone.rb)) * n, way);
    let u = clamp(along / dot(way, way), 0.0, 1.0);
    return mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(path, record, wo);
    }
    v.record = record;
    v.surface = rna_surface(record);
    v.kind = surface_kind(v.surface);
    v.part = surface_part(v.surface);
    if v.kind == OF_MATERIAL {
        v.shading = bumped_normal(record, v.b1, v.b2, v.n, v.ng, wo);
    }
    v.wo = wo;
    v.instance = path.instance;
    v.x_world = rna_world_point(v.x, path.instance);
    v.n_world = rna_world_direction(v.shading, path.instance);
    v.ng_world = rna_world_direction(v.ng, path.instance);
    return v;
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    let step = object_step(v.instance);
    return v.x_world + select(step, -step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Origin of the visibility ray along wi against the asset itself; object space.
fn leaving_point(v: Vertex, wi: vec3f) -> vec3f {
    if v.kind == OF_FIBERS {
        return v.x;
    }
    let extent = rna_instances[v.instance].extent;
    return rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, extent);
}

fn instance_scale(instance: u32) -> f32 {
    return rna_instances[instance].scale;
}
`,"row_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

struct RnaRow { // 64 bytes
    position: vec3<u32>, // 0; object space
    h: u32, // 12
    axis: vec3<u32>, // 16; normal or tangent
    reserved: u32, // 28
    wo: vec3<u32>, // 32
    reserved_2: u32, // 44
    wi: vec3<u32>, // 48
    reserved_3: u32, // 60
}
`,"segment.wgsl":`// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn rna_cone(point: u32) -> RnaCone {
    let a = rna_points[point];
    let b = rna_points[point + 1u];
    return RnaCone(a.xyz, a.w, b.xyz, b.w);
}

// Along d from p to where it enters the sphere; RNA_FAR where it does not.
fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    let v = p - centre;
    let along = dot(v, d);
    let rest = v - along * d;
    let h = radius * radius - dot(rest, rest);
    if h <= 0.0 {
        return RNA_FAR;
    }
    return -along - sqrt(h);
}

// How far p is outside of the cone; negative inside.
fn rna_cone_distance(cone: RnaCone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let size = length(axis);
    let dr = cone.ra - cone.rb;
    let v = p - cone.a;
    let y = dot(v, axis) / size;
    let x = length(v - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size <= abs(dr) {
        return select(to_b, to_a, dr > 0.0);
    }
    let slope = dr / size;
    let lean = sqrt(1.0 - slope * slope);
    let along = y * lean - x * slope;
    if along <= 0.0 {
        return to_a;
    }
    if along >= size * lean {
        return to_b;
    }
    return x * lean + y * slope - cone.ra;
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. \`from\` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), vec3f(0.0));
    entry.normal = p + entry.t * d - select(cone.b, cone.a, ta < tb);
    let axis = cone.b - cone.a;
    let v = p - cone.a;
    let dr = cone.ra - cone.rb;
    let squared = dot(axis, axis);
    let d2 = squared - dr * dr;
    let m1 = dot(axis, v);
    let m2 = dot(axis, d);
    let k2 = d2 - m2 * m2;
    let k1 = d2 * dot(d, v) - m1 * m2 + m2 * dr * cone.ra;
    let k0 = d2 * dot(v, v) - m1 * m1 + 2.0 * m1 * dr * cone.ra - squared * cone.ra * cone.ra;
    let h = k1 * k1 - k0 * k2;
    if d2 <= 0.0 || h < 0.0 || k2 == 0.0 {
        return entry;
    }
    for (var sign = -1.0; sign <= 1.0; sign += 2.0) {
        let side = (sign * sqrt(h) - k1) / k2;
        let y = m1 - cone.ra * dr + side * m2;
        let normal = d2 * (v + side * d) - axis * y;
        if y > 0.0 && y < d2 && side < entry.t && dot(normal, d) < 0.0 {
            entry = RnaEntry(side, normal);
        }
    }
    return entry;
}

// Whether p, on a segment, is inside the one before or after it: there is no surface there.
fn rna_in_neighbour(segment: RnaPrimitive, p: vec3f) -> bool {
    if (segment.b & RNA_HAS_BEFORE) != 0u {
        let before = rna_cone(segment.a - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.b & RNA_HAS_AFTER) != 0u {
        let after = rna_cone(segment.a + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
    let cone = rna_cone(segment.a);
    let shift = dot(0.5 * (cone.a + cone.b) - ray.origin, ray.direction);
    let p = ray.origin + shift * ray.direction;
    let entry = rna_enter_cone(cone, p, ray.direction);
    let t = entry.t + shift;
    if entry.t >= RNA_FAR || !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    if rna_in_neighbour(segment, p + entry.t * ray.direction) {
        return miss;
    }
    return RnaEntry(t, normalize(entry.normal));
}
`,"surface.wgsl":`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi.
fn rna_surface(x: vec3f, n: vec3f, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`,"surface_blocks.wgsl":`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(0.5 * dot(gap, gap) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    rna_put(slot, vec4f(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    if slot == RNA_NONE {
        return;
    }
    var q = n + 0.1 * features;
    let size = length(q);
    if size < 1e-6 {
        q = n;
    } else {
        q = q / size;
    }
    let m = rna_halfway(wo, wi, q);
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    let m = rna_halfway(wo, wi, n);
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, wo, wi);
}
`,"triangle.wgsl":`// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
// Ray/Triangle Intersection (JCGT 2(1), 2013).

// Coordinates with the ray's largest one last.
fn rna_turned(v: vec3f, axis: u32) -> vec3f {
    if axis == 0u {
        return v.yzx;
    }
    if axis == 1u {
        return v.zxy;
    }
    return v;
}

fn rna_largest_axis(d: vec3f) -> u32 {
    let size = abs(d);
    if size.x > size.y && size.x > size.z {
        return 0u;
    }
    return select(2u, 1u, size.y > size.z);
}

// (t, b1, b2), t of RNA_FAR for a miss.
fn rna_meet_triangle(ray: RnaRay, p0: vec3f, p1: vec3f, p2: vec3f) -> vec3f {
    let miss = vec3f(RNA_FAR, 0.0, 0.0);
    let axis = rna_largest_axis(ray.direction);
    let d = rna_turned(ray.direction, axis);
    let shear = vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z);
    let a = rna_turned(p0 - ray.origin, axis);
    let b = rna_turned(p1 - ray.origin, axis);
    let c = rna_turned(p2 - ray.origin, axis);
    let a2 = a.xy - shear.xy * a.z;
    let b2 = b.xy - shear.xy * b.z;
    let c2 = c.xy - shear.xy * c.z;
    let u = c2.x * b2.y - c2.y * b2.x;
    let v = a2.x * c2.y - a2.y * c2.x;
    let w = b2.x * a2.y - b2.y * a2.x;
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return miss;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return miss;
    }
    let t = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
    if !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    return vec3f(t, v / sum, w / sum);
}
`,"visibility.wgsl":`// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

// From x, at barycentric coordinates b of a triangle, onto the smooth surface it stands for.
fn rna_lift(x: vec3f, b: vec3f, p: mat3x3f, n: mat3x3f) -> vec3f {
    return b.x * max(0.0, dot(p[0] - x, n[0])) * n[0]
        + b.y * max(0.0, dot(p[1] - x, n[1])) * n[1]
        + b.z * max(0.0, dot(p[2] - x, n[2])) * n[2];
}

// n: interpolated, ng: of the triangle; extent: largest absolute coordinate of the asset.
fn rna_leaving_origin(
    x: vec3f, n: vec3f, ng: vec3f, lift: vec3f, wi: vec3f, extent: f32,
) -> vec3f {
    let step = extent * 0x1p-18f;
    let above_plane = dot(ng, wi);
    let is_smooth = dot(n, ng) > 0.0;
    let above = select(above_plane, dot(n, wi), is_smooth);
    if is_smooth && above > 0.0 && above_plane < 0.1 {
        return x + (1.0 - max(0.0, above_plane) / 0.1) * lift + step * ng;
    }
    return x + select(step, -step, above < 0.0) * ng;
}
`,"weights_storage.wgsl":`// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`,"weights_uniform.wgsl":`// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`};var xt=`// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light: LIGHT_SUN and so on
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // of the queries, + 1
    form: u32,     // of the answers: FORM_TRANSPORT, two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    pixels: u32,   // of the whole picture
    shares: f32,   // rays a pixel of the first look's edges
}

const FORM_TRANSPORT = 0u;
const FORM_EMISSION = 1u;
const FORM_ENVIRONMENT = 2u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
}

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var fa=`// What decoders of lobes are told of the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn tell_visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= count[0] {
        return;
    }
    let pixel = band[count[at + 1u]];
    let record = primitives[pixel.wo.w];
    let is_segment = (record.tag & RNA_IS_SEGMENT) != 0u;
    let second = select(record.b, record.a + 1u, is_segment);
    let third = select(record.c, record.a, is_segment);
    for (var k = 0u; k < 4u; k++) {
        let first = (1.0 - pixel.b1 - pixel.b2) * harmonic(record.a, k);
        columns[4u * at + k] = first + pixel.b1 * harmonic(second, k) + pixel.b2 * harmonic(third, k);
    }
}
`;var ha=`// A ray from the camera through each pixel of the band, to the query of its first hit.

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    return found;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, wo: vec3f) -> Pixel {
    var pixel: Pixel;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        var path: Path;
        path.origin = frame.camera;
        path.direction = -wo;
        path.t = hit.t;
        path.normal = hit.normal;
        v = segment_vertex(path, record, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
    return pixel;
}

@compute @workgroup_size(64)
fn trace_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let place = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter) + view.shift;
    let d = normalize(frame.corner + at.x * frame.step_x + at.y * frame.step_y);
    let ray = RnaRay(frame.camera, 0.0, d, RNA_FAR);
    let found = closest_through(ray, RNA_NOTHING, chance_of(number));
    var pixel = pixel_of(found.hit, -d);
    pixel.through = found.weight;
    band[k] = pixel;
}

// The normals of hits whose primitives and barycentric coordinates are in the band.
@compute @workgroup_size(64)
fn find_normals(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let hit = RnaHit(0.0, 0u, band[k].wo.w, band[k].b1, band[k].b2, vec3f(0.0));
        band[k].axis = pixel_of(hit, bitcast<vec3f>(band[k].wo.xyz)).axis;
    }
}
`;var pa=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, fisher_cosine(u.y / share, MIRROR_KAPPA), u.x));
    }
    let rest = (u.y - share) / (1.0 - share);
    let all_sides = rest < FROM_ALL_SIDES;
    let v = select((rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES), rest / FROM_ALL_SIDES, all_sides);
    let ball = along_axis(vec3f(0.0, 0.0, 1.0), 1.0 - 2.0 * v, u.x);
    return normalize(ball + select(at.n * 1.0001, vec3f(0.0), all_sides));
}

fn density_about(at: Surroundings, wi: vec3f) -> f32 {
    if all(at.n == vec3f(0.0)) {
        return SPHERE_PDF;
    }
    let rest = mix(max(0.0, dot(at.n, wi)) / PI, SPHERE_PDF, FROM_ALL_SIDES);
    return mix(rest, fisher_pdf(dot(at.mirror, wi), MIRROR_KAPPA), mirrored_share(at));
}

fn surroundings_of(pixel: Pixel) -> Surroundings {
    if pixel.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if rna_is_segment(rna_primitives[pixel.wo.w]) {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// The direction that lobes are asked with. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(number: u32, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let u = at_point(number, DIRECTION);
        let wi = normalize(along_axis(vec3f(0.0, 1.0, 0.0), 1.0 - 2.0 * u.y, u.x) + vec3f(0.0, 1.0001, 0.0));
        return Arrival(wi, view.colour / max(wi.y, 1e-3));
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    let m = select(reflect(-wo, axis), reflect(wo, axis), rna_is_segment(rna_primitives[pixel.wo.w]));
    return Arrival(m, vec3f(1.0));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == LIGHT_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == LIGHT_GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let at = surroundings_of(pixel);
    if view.kind == LIGHT_MIRROR {
        return mirrored(number, pixel);
    }
    if view.kind == LIGHT_ENVIRONMENT {
        let bright = sample_image(0u, at_point(number, LIGHT));
        return Arrival(bright.wi, bright.radiance / (bright.pdf + density_about(at, bright.wi)));
    }
    let wi = direction_about(at, at_point(number, DIRECTION));
    let sky = look_up_image(0u, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + density_about(at, wi)));
}

// How much of the light along wi the asset itself lets through to a point of it.
fn visibility_of(pixel: Pixel, wi: vec3f) -> vec3f {
    let record = rna_primitives[pixel.wo.w];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = rna_strand(record);
    }
    return start_visibility(0u, RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR), v.strand);
}

// The ground, seen along d, shows the shadow and fades with the distance: what it sends on of light along wi; and how
// much it covers.
fn ground_seen(d: vec3f, wi: vec3f) -> vec4f {
    if view.ground_size == 0.0 || d.y * (frame.camera.y - view.ground) >= 0.0 {
        return vec4f(0.0);
    }
    let x = frame.camera + d * ((view.ground - frame.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    if all(weight <= vec3f(0.0)) {
        return vec4f(0.0, 0.0, 0.0, fade);
    }
    let step = 0x1p-18f * rna_instances[0].extent;
    let way = RnaRay(x + vec3f(0.0, step, 0.0), 0.0, wi, RNA_FAR);
    return vec4f(weight * start_visibility(0u, way, RNA_NOTHING), fade);
}

@compute @workgroup_size(64)
fn light_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    var pixel = band[k];
    let arrival = arrival_at(view.first + k, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    pixel.radiance = pixel.through * arrival.radiance;
    if pixel.axis.w != 0u {
        pixel.visibility = visibility_of(pixel, arrival.wi);
    } else {
        let ground = ground_seen(-bitcast<vec3f>(pixel.wo.xyz), arrival.wi);
        pixel.radiance *= ground.xyz;
        pixel.coverage = ground.w;
    }
    band[k] = pixel;
}
`;var ma=`// The first look without jagged edges: more rays a pixel, each with the light of the pixels nearby that saw what it sees.

@group(2) @binding(0) var<storage, read_write> seen: array<vec4<u32>>; // from pixels' middles: distance, axis, part + 1
@group(2) @binding(1) var<storage, read_write> look: array<vec4f>;

const UNLIKE = 8.0; // weight of differences: of axes, and of distances to a plane in pixels
const APART = 3.0;  // and of the distance in the picture, pixels squared
const APART_ON_GROUND = 0.5; // whose light is noisy

fn raw_direction(place: vec2f) -> vec3f {
    return frame.corner + place.x * frame.step_x + place.y * frame.step_y;
}

// What the band's pixels see from their middles.
@compute @workgroup_size(64)
fn remember(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let pixel = band[k];
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let away = length(bitcast<vec3f>(pixel.position.xyz) - frame.camera);
    let packed = vec2<u32>(pack2x16snorm(axis.xy), pack2x16snorm(vec2f(axis.z, 0.0)));
    seen[view.first + k] = vec4<u32>(bitcast<u32>(away), packed, pixel.axis.w);
}

// How unlike what the pixel at \`place\` saw from its middle is to a hit of the same part.
fn difference(hit: Pixel, other: vec4<u32>, place: vec2f) -> f32 {
    if hit.axis.w == 0u {
        return 0.0;
    }
    let n = bitcast<vec3f>(hit.axis.xyz);
    let raw = raw_direction(place);
    let away = bitcast<f32>(other.x);
    let x = frame.camera + away * normalize(raw);
    let size = away * length(frame.step_x) / length(raw); // of a pixel there
    let off = abs(dot(n, x - bitcast<vec3f>(hit.position.xyz))) / max(size, 1e-30);
    return 1.0 - dot(n, vec3f(unpack2x16snorm(other.y), unpack2x16snorm(other.z).x)) + off;
}

// The light of the neighbours that are like the band's hit, whose ray went beside the middle by the view's shift.
fn light_beside(number: u32, hit: Pixel) -> vec4f {
    let middle = vec2<i32>(vec2<u32>(number % frame.width, number / frame.width));
    let narrow = select(APART, APART_ON_GROUND, hit.axis.w == 0u);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var j = 0; j < 9; j++) {
        let step = vec2<i32>(j % 3 - 1, j / 3 - 1);
        let at = middle + step;
        let there = u32(at.y) * frame.width + u32(at.x);
        if at.x < 0 || at.y < 0 || at.x >= i32(frame.width) || there >= view.pixels || seen[there].w != hit.axis.w {
            continue;
        }
        let apart = vec2f(step) - view.shift;
        let unlike = min(difference(hit, seen[there], vec2f(at) + 0.5), 4.0);
        let weight = exp(-UNLIKE * unlike - narrow * dot(apart, apart));
        sum += weight * sums[there];
        total += weight;
    }
    if total == 0.0 {
        return select(sums[number], vec4f(0.0), hit.axis.w == 0u); // nobody saw such a thing
    }
    return sum / total;
}

// One of \`view.shares\` rays a pixel.
@compute @workgroup_size(64)
fn smooth_edges(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let before = select(look[number], vec4f(0.0), view.is_first == 1u);
    look[number] = before + light_beside(number, band[k]) / view.shares;
}
`;var $s=`// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; then its visibility
@group(1) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(1) @binding(2) var<storage, read> count: array<u32>; // [0]
@group(1) @binding(3) var<storage, read> columns: array<vec4f>; // 4 a row
@group(2) @binding(0) var<uniform> light: LobeLight;
@group(2) @binding(1) var prefiltered: texture_2d_array<f32>;
@group(2) @binding(2) var smooth_sampler: sampler;

fn mean_under(lobe: RnaLobe) -> vec3f {
    let d = lobe.axis;
    let x = light.turn.x * d.x - light.turn.y * d.z;
    let z = light.turn.y * d.x + light.turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    let azimuth = select(0.0, atan2(x, -z), sine > 0.0);
    let size = vec2f(textureDimensions(prefiltered));
    let polar = atan2(sine, d.y) / 3.14159265; // the first row is one pole, the last one the other
    let place = vec2f(0.5 + azimuth / 6.28318531, (polar * (size.y - 1.0) + 0.5) / size.y);
    let level = clamp(log2(lobe.kappa / light.least_kappa) * light.an_octave, 0.0, light.levels - 1.0);
    let wide = u32(level);
    let a = textureSampleLevel(prefiltered, smooth_sampler, place, wide, 0.0).xyz;
    let b = textureSampleLevel(prefiltered, smooth_sampler, place, min(wide + 1u, u32(light.levels) - 1u), 0.0).xyz;
    return mix(a, b, level - f32(wide));
}

@compute @workgroup_size(64)
fn light_by_lobes(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= count[0] {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let place = rna_run_lobes(bitcast<vec3f>(at.position), axis, bitcast<f32>(at.h), wo, m, visibility);
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.reserved_3));
        sum += lobe.amplitude * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
`;var Gs=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

@group(2) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(2) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

// What a light brings to the ground, and the coverage. \`sums\` are of the whole picture.
@compute @workgroup_size(64)
fn begin(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let is_query = band[k].axis.w != 0u;
    let covered = select(band[k].coverage, 1.0, is_query) * f32(view.counts_coverage);
    let before = select(sums[view.first + k], vec4f(0.0), view.is_first == 1u);
    sums[view.first + k] = before + vec4f(select(band[k].radiance, vec3f(0.0), is_query), covered);
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    rows[at] = RnaRow(pixel.position.xyz, pixel.position.w, pixel.axis.xyz, 0u, pixel.wo.xyz, 0u, wi.xyz, bitcast<u32>(free));
}

@compute @workgroup_size(64)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let k = atomicLoad(&count[at + 1u]);
    let pixel = band[k];
    var radiance = pixel.through * answers[at].xyz;
    if view.form == FORM_TRANSPORT {
        radiance = pixel.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, pixel.visibility);
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var qs=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB, alpha
// where the page behind it shows.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec4f, // linear light of the screen, and 1; or zeros, where the page shows
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    first_look: f32, // share of the first look in what is shown, 0 to 1
    rows_ahead: f32, // from the top, which have one sample more than \`rounds\`
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

// The mean of the samples and the first look.
fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    let k = place.y * u32(shown.picture.x) + place.x;
    if shown.first_look >= 1.0 {
        return first_look[k];
    }
    let mean = sums[k] / (shown.rounds + f32(f32(place.y) < shown.rows_ahead));
    if shown.first_look <= 0.0 {
        return mean;
    }
    return mix(mean, first_look[k], shown.first_look);
}

// As rna_render/image/view_transform.py, which names the source.
fn filmic(radiance: vec3f) -> vec3f {
    let c = 1.461926 * min(radiance, vec3f(1e9));
    let x = vec3f(dot(c, vec3f(0.59719, 0.35458, 0.04823)), dot(c, vec3f(0.07600, 0.90834, 0.01566)),
                  dot(c, vec3f(0.02840, 0.13383, 0.83777)));
    // Both parts divided by x, so that none overflows.
    let inverse = 1.0 / max(x, vec3f(1e-9));
    let y = (x + 0.0245786 - 0.000090537 * inverse) / (0.983729 * x + 0.4329510 + 0.238081 * inverse);
    return vec3f(dot(y, vec3f(1.60475, -0.53108, -0.07367)), dot(y, vec3f(-0.10208, 1.10813, -0.00605)),
                 dot(y, vec3f(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, premultiplied, of a mean.
fn displayed(mean: vec4f) -> vec4f {
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let behind = max(0.0, 1.0 - mean.w) * shown.backdrop.w;
    let alpha = min(mean.w, 1.0) + behind;
    let linear = (clamp(light, vec3f(0.0), vec3f(1.0)) + behind * shown.backdrop.xyz) / max(alpha, 1e-4);
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return vec4f(clamp(encoded, vec3f(0.0), vec3f(1.0)), 1.0) * alpha;
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y);
    let here = displayed(mean);
    if (shown.spread == 0.0) {
        return here;
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = here;
    var total = 1.0;
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y);
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            let weight = exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
            sum += weight * value;
            total += weight;
        }
    }
    return sum / total;
}
`;var da=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, vec3f(0.0));
}
`;var ga=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let r of[xt,$s,Gs,qs])gi(r);var _a=r=>r in ft?[r]:wt[r].flatMap(_a),Vt=(r,e=ft)=>[...new Set(r.flatMap(_a))].map(t=>e[t]).join(`
`);function vr(r,...e){return Object.entries(r).map(([n,s])=>`const ${n}: u32 = ${s}u;
`).join("")+Vt(e)}function yr({hasSegments:r,hasTextures:e}){let t={...ft};return r||(t["segment.wgsl"]=da),e||Object.assign(t,{"normal_maps.wgsl":ga,"render/transmittance.wgsl":""}),{hit:Vt(wt.hit,t)+xt+ha,light:[Vt(wt.light,t),xt,_i,pa].join(`
`)}}var bt={columns:Vt(wt.columns)+xt+fa,lobes:`${ft["environment_lobes.wgsl"]}
${ft["row_records.wgsl"]}
${$s}`,look:Vt(wt.queue)+xt+ma,queue:Vt(wt.queue)+xt+Gs,show:qs};var wr=class{constructor(e){this.device=e,this.made=new Map}get(e,t,n){let s=`${t}
${e}`;return this.made.has(s)||this.made.set(s,this._make(e,t,n)),this.made.get(s)}async _make(e,t,n){let s=await pr(this.device,e),i=n?this.device.createPipelineLayout({bindGroupLayouts:n}):"auto";return this.device.createComputePipelineAsync({layout:i,compute:{module:s,entryPoint:t}})}},Xt=class{static make(e,t,n,s,i,o){let l={constants:{RNA_COLOURS:s.outputs===6?2:1},parts:[n.kind,"evaluate"],kernel:"",entryPoint:"rna_evaluate"};return this.of(e,t,_r(n,s,i),o,l)}static async of(e,t,{weights:n,record:s,groups:i},o,{constants:c,parts:l,kernel:f,entryPoint:h}){let m=new this,{UNIFORM_WEIGHTS:_}=ie,v=n.length/4<=_,x=v?"weights_uniform.wgsl":"weights_storage.wgsl";m.pipeline=await t.get(vr({RNA_GROUPS:i,...c},x,...l)+f,h);let{UNIFORM:A,STORAGE:N}=GPUBufferUsage,D=v?new Float32Array(4*_):n;return v&&D.set(n),m.buffers=[ne(e,s,A,"a decoder"),ne(e,D,v?A:N,"a decoder")],m.part=yn(e,m.pipeline,0,[...m.buffers,...o]),m.device=e,m}run(e,{rows:t,answers:n,count:s},i){this.dispatch(e,[t,n,s],i)}dispatch(e,t,n,s=[]){this.bound??=yn(this.device,this.pipeline,1,t),he(e,this.pipeline,[this.part,this.bound,...s],n)}delete(){for(let e of this.buffers)e.destroy()}};function*va(r,[e,t]){let n=e+1,s=r.reduce((c,l)=>c+l,0)/r.length||1,i=yield*If(r,e,t,s),o=new Uint16Array(4*t*n*19);for(let c=0;c<19;c++){let l=.25*2**(c/2);for(let f=0;f<n;f++){let h=Nf(i,Math.PI*f/e,e,t/2,l);Mf(o,4*t*(c*n+f),h,t),yield}}return{texels:o,width:t,height:n,levels:19,unit:s}}var ya=r=>Float64Array.from({length:r},(e,t)=>Math.cos(2*Math.PI*t/r)),wa=(r,e)=>2*Math.PI*(Math.cos(Math.PI*r/e)-Math.cos(Math.PI*(r+1)/e));function*If(r,e,t,n){let s=t/2,i=new Float64Array(6*e*s),o=ya(t);for(let c=0;c<e;c++){yield;let l=wa(c,e)/t;for(let f=0;f<s;f++)for(let h=0;h<t;h++){let m=f*h,_=6*(c*s+f),v=3*(c*t+h),x=l/n*o[m%t],A=l/n*o[(m+.75*t)%t];for(let N=0;N<3;N++)i[_+N]+=r[v+N]*x,i[_+3+N]+=r[v+N]*A}}return i}function Nf(r,e,t,n,s){let i=new Float64Array(6*n),o=new Float64Array(n),c=0;for(let l=0;l<t;l++){let f=Math.PI*(l+.5)/t,h=Math.exp(s*(Math.cos(e-f)-1));if(!(h<1e-6)){Of(s*Math.sin(e)*Math.sin(f),o),c+=h*o[0]*wa(l,t);for(let m=0;m<n&&o[m]>1e-6;m++){let _=h*o[m]*(m?2:1),v=6*(n*l+m),x=6*m;for(let A=0;A<6;A++)i[x+A]+=_*r[v+A]}}}return i.map(l=>l/c)}function Of(r,e){let t=Math.min(e.length-1,Math.ceil(8+6*Math.sqrt(r))),n=0;for(let o=t+8;o>0;o--)n=r/(2*o+r*n),o<=t&&(e[o]=n);let s=1,i=1;for(let o=1;o<=t;o++)s*=e[o],e[o]=s,i+=2*s;e[0]=1;for(let o=0;o<=t;o++)e[o]/=i;e.fill(0,t+1)}function Mf(r,e,t,n){let s=ya(n),i=n/2;for(;i>1&&t.subarray(6*i-6,6*i).every(o=>Math.abs(o)<1e-6);)i-=1;for(let o=0;o<n;o++){let c=0,l=0,f=0;for(let h=0,m=0,_=0;h<i;h++,m=(m+o)%n,_+=6){let v=s[m],x=s[(m+.75*n)%n];c+=t[_]*v+t[_+3]*x,l+=t[_+1]*v+t[_+4]*x,f+=t[_+2]*v+t[_+5]*x}[c,l,f].forEach((h,m)=>{r[e+4*o+m]=Pf(h)})}}var xa=new Float32Array(1),Lf=new Uint32Array(xa.buffer);function Pf(r){return xa[0]=Math.max(r,0),Math.max(0,Math.min(31743,(Lf[0]+4096>>>13)-114688))}var[ba,Aa,js]=["uniform","storage","read-only-storage"],xr=class{constructor(e){let{device:t,bandPixels:n}=e;Object.assign(this,{device:t,engine:e,rest:null}),this.columns=ne(t,4*Gt*n),this.record=ne(t,Je("LobeLight"),GPUBufferUsage.UNIFORM),this.layouts=[Ie(t,{0:ba}),Ie(t,{0:Aa,1:ba}),Ie(t,{0:js,1:js,2:js,3:Aa})],this.sampler=t.createSampler({addressModeU:"repeat",magFilter:"linear",minFilter:"linear"})}async begin(e,t){let n=new Int8Array(4*e.points.length);t.forEach(({environment:s},i)=>n.set(s.harmonics??[],16*e.parts[i].point)),this.harmonics=ne(this.device,n,void 0,"the asset's visibility"),this.tell=await this.engine.pipelines.get(bt.columns,"tell_visibility",this.layouts)}set({rest:e,turn:t,radiance:n}){let{device:s}=this,{texels:i,width:o,height:c,levels:l,unit:f}=e;this.rest!==e&&(this.texture?.destroy(),this.texture=s.createTexture({size:[o,c,l],format:"rgba16float",usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST}),s.queue.writeTexture({texture:this.texture},i,{bytesPerRow:8*o,rowsPerImage:c},[o,c,l]),this.rest=e),s.queue.writeBuffer(this.record,0,ce("LobeLight",{colour:n.map(h=>h*f),levels:l,turn:[Math.cos(t),Math.sin(t)],least_kappa:.25,an_octave:2}))}run(e,{count:t},n){let{engine:{frameRecord:s,band:i,viewRecord:o,geometry:c},device:l,layouts:f}=this;this.groups??=[[s],[i,o],[t,c[1],this.harmonics,this.columns]].map((h,m)=>Ce(l,f[m],h)),he(e,this.tell,this.groups,n)}delete(){for(let e of[this.harmonics,this.columns,this.record,this.texture])e?.destroy()}},br=class extends Xt{static async make(e,t,n,s,i){let{environment:o}=n,c=o.harmonics?Gt:0,l=await super.of(e,t,_r({...n,planes:o.planes},o,o.inputs,c),s,{constants:{RNA_LOBES:o.lobes,RNA_IS_FIBER:+(n.kind==="fiber"),RNA_VISIBILITY_GROUPS:c/4},parts:[n.kind],kernel:bt.lobes,entryPoint:"light_by_lobes"});return Object.assign(l,{shared:i})}run(e,t,n){let{shared:s,device:i,pipeline:o}=this;if(s.run(e,t,n),this.texture!==s.texture){this.texture=s.texture;let c=[{buffer:s.record},s.texture.createView({dimension:"2d-array"}),s.sampler];this.lit=i.createBindGroup({layout:o.getBindGroupLayout(2),entries:c.map((l,f)=>({binding:f,resource:l}))})}this.dispatch(e,[t.rows,t.answers,t.count,s.columns],n,[this.lit])}};var xn=1<<17,zf=["transport","emission","environment"],Ar=class r{static async open(e){let t=new r,n=await Qo();Object.assign(t,{canvas:e,device:n,parts:[],lost:!1,bandPixels:xn}),n.lost.then(({reason:i,message:o})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${o||i})`)}),n.addEventListener("uncapturederror",({error:i})=>{t.error??=i}),t.context=e.getContext("webgpu");let s=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:n,format:s,alphaMode:"premultiplied",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new wr(n),t.compiled=t._compile(s),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,n=await pr(t,bt.show),[s,i,o]=["uniform","storage","read-only-storage"],c=Ie(t,{0:i,1:s});this.rayLayout=[Ie(t,{0:s,4:o,5:o}),c,Ie(t,{0:o,1:o,2:o,3:o,4:o})],this.queueLayout=[Ie(t,{0:s,2:i}),c,Ie(t,{0:i,1:i,2:i})],this.lookLayout=[...this.queueLayout.slice(0,2),Ie(t,{0:i,1:i})];let[l,f,h,m,_,v]=await Promise.all([...["begin","gather","scatter"].map(x=>this.pipelines.get(bt.queue,x,this.queueLayout)),...["remember","smooth_edges"].map(x=>this.pipelines.get(bt.look,x,this.lookLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:n,entryPoint:"corner"},fragment:{module:n,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:f,scatter:h,remember:m,smooth:_},shown:v}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=ne(e,ce("Frame",{}),t),this.viewRecord=ne(e,Je("View"),t),this.showRecord=ne(e,Je("Show"),t),this.band=ne(e,Je("Pixel")*xn),this.queue={rows:ne(e,Je("RnaRow")*xn),answers:ne(e,32*xn),count:ne(e,4*(xn+4))},this._bind()}async setAsset(e,t){this._deleteAsset(),await this.compiled;let n=t.every(({environment:c})=>c);this.lobeLight=n?new xr(this):null;let s=Promise.all(t.map(c=>this._makePart(c))),i=Promise.all([s,this._compileRays(t),this._storeGeometry(e,t)]);i.catch(()=>s.then(c=>c.forEach(Ea)).catch(()=>{}));let[o]=await i;Object.assign(this,{parts:o,hasLobes:n}),this._makeSums()}async _storeGeometry(e,t){let n=await e;performance.mark("hierarchy");let{device:s}=this,i=(o,c)=>ne(s,o,void 0,`the asset's ${c}`);this.geometry=[i(n.nodes,"hierarchy"),i(n.primitives,"geometry"),i(n.points,"geometry"),i(Df(n.extent),"geometry"),i(n.normals,"geometry")],this.lightsAt=n.table.length/4,this.table=ne(s,4*n.table.length+Je("Light")),s.queue.writeBuffer(this.table,0,n.table),this.arrays=n,this._storeImages(),await this.lobeLight?.begin(n,t)}async _compileRays(e){let{pipelines:t}=this;this.raySources=yr({hasSegments:e.some(({kind:i})=>i==="fiber"),hasTextures:e.some(Uf)});let[n,s]=await Promise.all([t.get(this.raySources.hit,"trace_pixels",this.rayLayout),t.get(this.raySources.light,"light_pixels",this.rayLayout)]);this.kernels={hit:n,light:s,...this.queueKernels}}async _makePart(e){let{device:t,pipelines:n}=this,s=_=>[0,1,2].map(v=>ne(t,ua(_,v),void 0,"a plane of features")),i=s(e.planes),{environment:o}=e,c=this.lobeLight&&o.planes!==e.planes?s(o.planes):null,l=(_,v)=>Xt.make(t,n,e,_,v,i),[f,h,m]=await Promise.all([l(e.transport,e.inputs),e.emission&&l(e.emission,e.emission.inputs),this.lobeLight&&br.make(t,n,e,c??i,this.lobeLight)]);return{planes:[...i,...c??[]],transport:f,emission:h,environment:m}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=ne(this.device,4*(e.length+t.length),void 0,"the environment"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let n=e*t;this.target={width:e,height:t},!(this.sums&&n<=this.capacity&&n*8>=this.capacity)&&(this.capacity=n,this._makeSums())}_makeSums(){if(!this.capacity)return;for(let n of[this.sums,this.firstLook,this.seen])n?.destroy();let e=n=>ne(this.device,16*n,void 0,"the picture"),t=this.hasLobes?this.capacity:1;Object.assign(this,{sums:e(this.capacity),firstLook:e(t),seen:e(t)}),this._bind()}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:n,queue:s}=this,i=Ce(e,t[1],{0:this.band,1:this.viewRecord}),o=Ce(e,n[2],[s.rows,s.answers,s.count]),c=Ce(e,n[0],{0:this.frameRecord,2:this.sums});this.groups={rays:[Ce(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),i,Ce(e,t[2],this.geometry)],queue:[c,i,o],look:[c,i,Ce(e,this.lookLayout[2],[this.seen,this.firstLook])],show:yn(e,this.shown,0,[this.showRecord,this.sums,this.firstLook])}}trace(e,t,n,s){let{width:i}=this.target;this.span={first:n*i,pixels:(s-n)*i,jitter:e.jitter??1,shift:e.shift??[0,0]},this._writeFrame(e,t),this._writeView({}),this._run(o=>he(o,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:n}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:n},this._writeView(this.view),this._run(s=>{he(s,this.kernels.light,this.groups.rays,this.span.pixels),he(s,this.kernels.begin,this.groups.queue,this.span.pixels)}),e.kind==="mirror"&&this.lobeLight.set(e),this._decode(e.kind==="mirror"?"environment":"transport")}emission(){this._decode("emission")}remember(){this._run(e=>he(e,this.kernels.remember,this.groups.look,this.span.pixels))}smoothEdges(e,t){this._writeView({shares:e,isFirst:t}),this._run(n=>he(n,this.kernels.smooth,this.groups.look,this.span.pixels))}show({rounds:e,firstLook:t,rowsAhead:n,exposure:s,backdrop:i,filmic:o,spread:c}){let{width:l,height:f}=this.target,{canvas:h,device:m}=this;m.queue.writeBuffer(this.showRecord,0,ce("Show",{size:[h.width,h.height],picture:[l,f],backdrop:i,rounds:e,rows_ahead:n,exposure:s,filmic:Number(o),spread:c,first_look:t}));let _=m.createCommandEncoder(),v=this.context.getCurrentTexture().createView(),x=_.beginRenderPass({colorAttachments:[{view:v,loadOp:"clear",storeOp:"store"}]});x.setPipeline(this.shown),x.setBindGroup(0,this.groups.show),x.draw(3),x.end(),m.queue.submit([_.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await wn(this.device,this.sums,16*e*t))}_decode(e){for(let[t,n]of this.parts.entries()){let s=n[e];s&&(this._writeView({...this.view,part:t+1,form:zf.indexOf(e)}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(i=>{he(i,this.kernels.gather,this.groups.queue,this.span.pixels),s.run(i,this.queue,this.span.pixels),he(i,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),n=t.beginComputePass();e(n),n.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:n,stepY:s},i){let{lightsAt:o,arrays:c,span:l,target:f}=this;this.device.queue.writeBuffer(this.frameRecord,0,ce("Frame",{camera:e,corner:t,step_x:n,step_y:s,width:f.width,paths:l.pixels,sample:i,branches:1,depth:1,rays:ie.CAMERA_RAY,flags:c.transmits?ie.TRANSMITS:0,textures:c.texturesAt,lights:o}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:n=[0,0,0],ground:s,isFirst:i=!1,countsCoverage:o=!1,part:c=0,form:l=0,shares:f=1}){let{first:h,jitter:m,shift:_=[0,0]}=this.span,{width:v,height:x}=this.target,A=s&&{ground:s.height,ground_colour:s.colour,ground_size:s.size,middle:[s.x,s.z]};this.device.queue.writeBuffer(this.viewRecord,0,ce("View",{first:h,jitter:m,kind:jr[e],is_first:Number(i),direction:t,counts_coverage:Number(o),colour:n,part:c,form:l,shift:_,pixels:v*x,shares:f,...A}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:n,height:s,total:i,places:o}=this.environment,c={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=vi("image",{colour:t,...c,total:i,rows:s,columns:n});this.device.queue.writeBuffer(this.table,16*this.lightsAt,ce("Light",{kind:ie.IMAGE,group:ie.NONE,numbers:l,places:o.map(f=>f+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();this.lobeLight?.delete(),this.parts.forEach(Ea),this.parts=[],this.geometry=this.images=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}};function Ea({planes:r,...e}){r.forEach(t=>t.destroy());for(let t of Object.values(e))t?.delete()}var Uf=({transmittance:r,normalMaps:e})=>r.length+e.length>0,Df=r=>ce("RnaInstance",{to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1,root:1,rays:ie.CAMERA_RAY,extent:r});function Ra(r,e){let{cameraControls:t,disableZoom:n,wheelZoom:s}=r.settings;if(!t||e.type!=="wheel")return t;let i=r.place.getRootNode().activeElement===r.canvas;return!n&&(s==="always"||i||e.ctrlKey||e.metaKey)}function ka(r){let e=(t,n)=>(...s)=>{r.settings[n]||(t(...s),r.isTouched=!0,r.viewer.restart(s.at(-1)===!0),r.tell("camera",{byUser:!0}))};return{orbit:e((t,n)=>r.orbit.turn(t,n)),pan:e((t,n)=>r.orbit.pan(t,n),"disablePan"),zoom:e(t=>r.orbit.zoom(t),"disableZoom"),light:(t,n,s)=>{if(r.settings.disableLight)return;let i=Hn(r.lighting.rotation+t*180/Math.PI),o=$e(r.lighting.sunHeight+n*180/Math.PI,-10,90);r.setLight({rotation:i,sunHeight:o},{moving:s===!0,byUser:!0})},settle:()=>r.viewer.moving&&r.viewer.restart(),reset:()=>r.reset()}}var Sa=[[1,3],[-3,1],[3,-1],[-1,-3]].map(r=>r.map(e=>e/8)),Hf={kind:"sun",direction:[0,1,0],colour:[0,0,0]},Er=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{engine:e,canvas:t,orbit:n}),Object.assign(this,{lights:[],firstLights:null,shownCamera:null,ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,rowsAhead:0,ready:!1,stopped:!1,moving:!1,resting:!1,backdrop:null,coarsest:16,isCovered:()=>!1,stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1,t=16){Object.assign(this,{moving:e,coarsest:t}),Object.assign(this.stats,{rounds:0,scale:0,isSharp:!1}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}rest(e){this.resting=e,e||this.rouse?.()}stop(){return this.stopped=!0,this.rest(!1),this.pause(),this.wake?.(),this.running}async pictured(){for(;!this.shown;)await this._nextPicture()}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await this._nextPicture()}_nextPicture(){return new Promise(e=>this.addEventListener("shown",e,{once:!0}))}show(){if(!this.shown)return;let{rounds:e,firstLook:t}=this.shown,n=this.denoise&&e<12&&!t;this.engine.show({rounds:e,firstLook:t,rowsAhead:this.rowsAhead,exposure:2**this.exposure,backdrop:this.backdrop?[...this.backdrop,1]:[0,0,0,0],filmic:this.view==="filmic",spread:n?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let n=t===1&&!this.moving?this.rounds:+!this.firstLights;if(!await this._stage(e,t,n)||this.moving)return}}get _isHidden(){return!this.hasShown&&this.isCovered()}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,(this.firstLights??this.lights).length),t=this._isHidden?4:this.coarsest,n=1;for(;n<t&&e*this.msPerPixel/n**2>110;)n*=2;let s=[n],i=this.firstLights?2:1;for(;n>1;)s.push(n=n>4?n/4:n>i?i:1);return s}async _stage(e,t,n){let{engine:s,canvas:i}=this,o=Math.ceil(i.width/t),c=Math.ceil(i.height/t);this.shown=null,s.resize(o,c);let l={...this.orbit.camera(o,c),jitter:this.jitter},{firstLights:f}=this;if(f){let h=performance.now();if(!await this._look(e,{...l,jitter:0}))return!1;this._present(l,0,t,1),this._measure(performance.now()-h,o*c,f.length)}else if(!this.hasShown&&!this._isHidden){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(l,1,t,0,!1)}for(let h=0;h<n;h++){let m=performance.now();if(!await this._round(e,l,h,this.lights))return!1;let _=performance.now()-m;this._present(l,h+1,t,f?Bf(h+1):0),this._measure(_,o*c,this.lights.length),t===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*_:_)}return!0}_round(e,t,n,s){return this._bands(e,s.length,(i,o)=>{this._band(t,n,s,i,o),this.shown?.rounds===n&&(this.rowsAhead=o)})}async _look(e,t){let{engine:n,firstLights:s}=this;return await this._bands(e,s.length,(o,c)=>{this._band(t,0,s,o,c),n.remember()})?this._bands(e,1,(o,c)=>Sa.forEach((l,f)=>{n.trace({...t,shift:l},0,o,c),n.smoothEdges(Sa.length,f===0)})):!1}async _bands(e,t,n){let{engine:s}=this,{width:i,height:o}=s.target,c=this.msPerPixel*i*Math.max(1,t),l=Math.max(1,Math.min(o,Math.floor(120/c),Math.floor(s.bandPixels/i)));for(let f=0;f<o;f+=l)if(this.resting&&await new Promise(h=>{this.rouse=h}),n(f,Math.min(o,f+l)),await s.done(),e!==this.generation||this.stopped||s.lost)return!1;return!0}_band(e,t,n,s,i){let{engine:o}=this;o.trace(e,t,s,i),(n.length?n:[Hf]).forEach((l,f)=>o.light({...l,ground:this.ground},{isFirst:t===0&&f===0,countsCoverage:f===0})),o.emits&&o.emission()}_present(e,t,n,s,i=!0){Object.assign(this,{shown:{rounds:t,firstLook:s},shownCamera:{...e,...this.engine.target},rowsAhead:0}),this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:t,scale:n,isSharp:i&&n<=4}),this.dispatchEvent(new Event("shown"))}_measure(e,t,n){let s=e/(t*Math.max(1,n));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,s):.5*(this.msPerPixel+s)}},Bf=r=>Math.max(0,1-r/64)/(1+r/8);var $f=22e5,Gf=4,qf=6e4,Rr=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{place:e,notices:t,settings:n,losses:0,lives:0,isResting:!1}),this.look={backdrop:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,isCovered:()=>!1},new ResizeObserver(()=>this.resize()).observe(e)}begin(){return this.replace()}end(){this.lives+=1,this.begun=Promise.resolve(!1),this.viewer?.stop(),this.engine?.close(),Object.assign(this,{viewer:null,engine:null})}replace(){this.end(),this.since=performance.now();let e=this._begin().then(()=>e===this.begun?!!this.engine:this.begun,t=>e!==this.begun?this.begun:(this.end(),this.failed(t,"engine"),!1));return this.begun=e}async _begin(){let e=this.lives,t=document.createElement("canvas"),n=await Ar.open(t);if(e!==this.lives)return n.close();Object.assign(this,{engine:n,canvas:t}),this.place.replaceChildren(t),n.onlost=s=>this._lost(n,s),this.viewer=Object.assign(new Er(n,t,this.orbit),this.look,{resting:this.isResting}),this.viewer.addEventListener("shown",()=>this.pictured()),this.viewer.addEventListener("failed",({error:s})=>this._lost(n,Ta(s))),performance.mark("engine"),sa(t,ka(this),s=>Ra(this,s)),this.tell("engine"),this.resize(),await this.restore(n)}rest(e){this.isResting=e,this.viewer?.rest(e)}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.place,n=this.settings.pixelRatio??Math.min(devicePixelRatio,2),s=Math.min(n,Math.sqrt($f/Math.max(1,e*t))),i=Math.max(1,Math.round(e*s)),o=Math.max(1,Math.round(t*s));this.canvas.width===i&&this.canvas.height===o||(Object.assign(this.canvas,{width:i,height:o}),this.resized(),this.viewer.restart())}get wgsl(){return{compose:vr,sharedFiles:ft,rayKernels:yr}}reader(){return this.viewer.pause(),new mr(this.engine)}async screenshot(e="image/png",t=void 0){return await this.viewer.pictured(),this.viewer.show(),new Promise(n=>this.canvas.toBlob(n,e,t))}async _lost(e,t){if(e===this.engine){if(this.losses=performance.now()-this.since>qf?1:this.losses+1,this.losses>=Gf)return this.end(),this.failed(new G(`${t}, ${this.losses} times`),"engine");this.notices.say(`${t}; starting again`,!0,"engine"),await this.replace()&&this.notices.say(null,!1,"engine")}}tell(e,t){this.dispatchEvent(Object.assign(new Event(e),t))}failed(e,t){Ia(e)||console.error(e),this.notices.say(Ta(e),!1,t),this.failures=(this.failures??0)+1,this.tell("failed",{error:e,about:t})}},Ia=r=>r instanceof nn||r instanceof G,Ta=r=>Ia(r)?r.message:`this did not work: ${r.message??r}`;var ze=[64,128],Oa=[64,128],jf=512,Zf=4,Na=8,Yf=Math.cos(15*Math.PI/180),Wf=200,At=ze[0]*ze[1],Ma=r=>er(Vf(r));function*Vf(r){let e=Xf(r),t=Kf(e);yield;let{flux:n,sums:s,directions:i}=Jf(e.rgb,t);yield;let{excess:o,share:c}=Qf(n),l=eh(o),f=new Uint8Array(At);for(let _ of l)for(let v of _)f[v]=1;yield;let{radiance:h,up:m}=sh(e.rgb,t,_=>f[_]?1-c[_]:1);return{lights:l.map(_=>rh(_,o,v=>s[v]*c[Math.floor(v/3)],i)),up:m,rest:yield*va(h,Oa)}}function Xf({rgb:r,width:e,height:t}){let n=Math.ceil(jf/e);if(n<=1)return{rgb:r,width:e,height:t};let s=n*e,i=n*t,o=new Float32Array(3*s*i);for(let c=0;c<i;c++){let l=(c+.5)/n-.5,f=Math.floor(l),h=l-f,m=[Math.max(f,0),Math.min(f+1,t-1)];for(let _=0;_<s;_++){let v=(_+.5)/n-.5,x=Math.floor(v),A=v-x,N=[(x+e)%e,(x+1)%e];for(let D=0;D<3;D++){let q=(xe,Ne)=>r[3*(m[xe]*e+N[Ne])+D],X=q(0,0)+A*(q(0,1)-q(0,0)),Q=q(1,0)+A*(q(1,1)-q(1,0));o[3*(c*s+_)+D]=X+h*(Q-X)}}}return{rgb:o,width:s,height:i}}function Kf({width:r,height:e}){let t=new Float64Array(e),n=new Int32Array(e);for(let s=0;s<e;s++){let i=Math.PI*(s+.5)/e;t[s]=2*Math.PI/r*(Math.cos(Math.PI*s/e)-Math.cos(Math.PI*(s+1)/e)),n[s]=Math.min(ze[0]-1,Math.floor((1-Math.cos(i))/2*ze[0]))}return{width:r,height:e,solid:t,rows:n}}var La=({rows:r,width:e},t,n)=>r[t]*ze[1]+Math.floor(n/e*ze[1]);function Jf(r,e){let t=new Float64Array(3*At),n=new Float64Array(At),s=new Float64Array(3*At);for(let o=0,c=0;o<e.height;o++){let l=Math.PI*(o+.5)/e.height,f=e.solid[o],h=Math.sin(l),m=Math.cos(l);for(let _=0;_<e.width;_++,c+=3){let v=La(e,o,_),x=2*Math.PI*(_+.5)/e.width-Math.PI;n[v]+=f;for(let N=0;N<3;N++)t[3*v+N]+=r[c+N]*f;let A=Ue(r,c/3)*f;s[3*v]+=A*h*Math.sin(x),s[3*v+1]+=A*m,s[3*v+2]-=A*h*Math.cos(x)}}return{flux:t.map((o,c)=>o/n[Math.floor(c/3)]*(4*Math.PI/At)),sums:t,directions:s}}var Ue=(r,e)=>(r[3*e]+r[3*e+1]+r[3*e+2])/3;function Qf(r){let e=Zf*r.reduce((n,s)=>n+s,0)/r.length,t=Float64Array.from({length:At},(n,s)=>Math.max(0,1-e/Math.max(Ue(r,s),1e-30)));return{share:t,excess:r.map((n,s)=>n*t[Math.floor(s/3)])}}function bn(r){let e=1-2*(Math.floor(r/ze[1])+.5)/ze[0],t=Math.sqrt(1-e*e),n=2*Math.PI*(r%ze[1]+.5)/ze[1]-Math.PI;return[t*Math.sin(n),e,-t*Math.cos(n)]}var Ys=(r,e)=>r[0]*e[0]+r[1]*e[1]+r[2]*e[2];function Zs(r,e){let t=[0,0,0],n=0;for(let i of r){let o=Ue(e,i);n+=o,bn(i).forEach((c,l)=>{t[l]+=o*c})}let s=Math.hypot(...t)||1;return{flux:n,size:s,direction:t.map(i=>i/s)}}function eh(r){let e=[];for(let s=0;s<At;s++)Ue(r,s)>0&&e.push(s);e.sort((s,i)=>Ue(r,i)-Ue(r,s));let t=[],n=s=>e.filter(i=>Ys(bn(i),s)>Yf);for(;e.length&&t.length<Na;){let i=e.slice(0,Wf).map(c=>Zs(n(bn(c)),r)).reduce((c,l)=>l.flux>c.flux?l:c),o=new Set(n(i.direction));t.push([...o]),e=e.filter(c=>!o.has(c))}for(;t.length&&t.length<Na&&th(t,r););return t}function th(r,e){let t=m=>{let{flux:_,size:v}=Zs(m,e);return _-v},n=r.reduce((m,_)=>t(_)>t(m)?_:m),{direction:s}=Zs(n,e),i=nh(n,e,s),o=n.map(m=>Ys(bn(m),i)),c=0,l=0;n.forEach((m,_)=>{c+=Ue(e,m)*o[_],l+=Ue(e,m)});let[f,h]=[!0,!1].map(m=>n.filter((_,v)=>o[v]*l>c===m));return!f.length||!h.length?!1:(r.splice(r.indexOf(n),1,f,h),!0)}function nh(r,e,t){let n=[[0,0,0],[0,0,0],[0,0,0]];for(let i of r){let o=bn(i).map((l,f)=>l-t[f]),c=Ue(e,i);for(let l=0;l<3;l++)for(let f=0;f<3;f++)n[l][f]+=c*o[l]*o[f]}let s=[.6,.5,.62];for(let i=0;i<60;i++){let o=n.map(l=>Ys(l,s)),c=Math.hypot(...o);if(!c)break;s=o.map(l=>l/c)}return s}function rh(r,e,t,n){let s=[0,1,2].map(c=>r.reduce((l,f)=>l+t(3*f+c),0)),i=[0,0,0];for(let c of r){let l=n.subarray(3*c,3*c+3),f=Ue(e,c)/Math.hypot(...l);l.forEach((h,m)=>{i[m]+=f*h})}let o=Math.hypot(...i);return{direction:i.map(c=>c/o),colour:s}}function sh(r,e,t){let[n,s]=Oa,i=new Float64Array(3*n*s),o=new Float64Array(n*s),c=[0,0,0];for(let l=0,f=0;l<e.height;l++){let h=Math.max(0,Math.cos(Math.PI*(l+.5)/e.height)),m=e.solid[l];for(let _=0;_<e.width;_++,f+=3){let v=Math.floor(l/e.height*n)*s+Math.floor(_/e.width*s),x=m*t(La(e,l,_));o[v]+=m;for(let A=0;A<3;A++)i[3*v+A]+=x*r[f+A],c[A]+=x*h*r[f+A]}}return{radiance:i.map((l,f)=>l/o[Math.floor(f/3)]),up:c}}var ih={studio:["Studio",Ui],white:["White from all sides",()=>rr([1,1,1])]},oh=[1.06,1,.9],kr=Math.PI/180,Sr=class{constructor(){this.images=new Map(Object.entries(ih).map(([e,[t,n]])=>[e,{label:t,make:n}])),this.choice="studio",this.turntable=0,this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:[],imageTurn:0})}add(e,t){let n=`image-${this.images.size}`;return this.images.set(n,{label:e,make:()=>t}),n}tables(){let e=this.images.get(this.choice);return e.tables??=zi(e.make()),e.tables}get isPrepared(){return!(this.strength>0)||!!this.images.get(this.choice).first}async prepare(){let e=this.images.get(this.choice);e.first??=await(e.finding??=Ma(e.make()))}firstLights(){if(!(this.strength>0))return null;let{lights:e,rest:t,up:n}=this.images.get(this.choice).first,s=this._turn(),i=c=>c.map(l=>l*this.strength),o=e.map(({direction:c,colour:l})=>({kind:"sun",direction:Pa(c,s),colour:i(l)}));return[...this._suns(),...o,{kind:"mirror",colour:i(n),radiance:i([1,1,1]),turn:s,rest:t}]}lights(){let e=this._suns(),t=[0,0,0];for(let{direction:n,colour:s}of e)s.forEach((i,o)=>{t[o]+=i*Math.max(0,n[1])});if(this.strength>0){let n=[this.strength,this.strength,this.strength],s=this._turn();e.push({kind:"environment",colour:n,angle:s},{kind:"aroundPoint",colour:n,angle:s}),this.tables().up.forEach((i,o)=>{t[o]+=i*this.strength})}return{lights:e,irradiance:t}}_turn(){return(this.rotation+this.turntable+this.imageTurn)*kr}_suns(){let e=(this.rotation+this.turntable)*kr;return(this.suns??[this._sun()]).filter(({irradiance:t})=>t.some(n=>n>0)).map(({direction:t,irradiance:n})=>({kind:"sun",direction:Pa(t,e),colour:n}))}_sun(){let e=this.sunHeight*kr,t=this.sunAzimuth*kr;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:oh.map(n=>n*this.sun)}}};function Pa([r,e,t],n){let s=Math.cos(n),i=Math.sin(n),o=Math.hypot(r,e,t);return[(s*r+i*t)/o,e/o,(s*t-i*r)/o]}var Fa=(r,e)=>r.reduce((t,n,s)=>t+n*e[s],0),ah=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],ch=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function lh(r){let e=ah.map(t=>{let n=1.461926*Fa(t,r);return(n*(n+.0245786)-90537e-9)/(n*(.983729*n+.432951)+.238081)});return ch.map(t=>Fa(t,e))}function Ca(r){let e=[...r];for(let t=0;t<60;t++){let n=lh(e);e=e.map((s,i)=>s*Math.min(2,Math.max(.5,r[i]/Math.max(n[i],1e-6))))}return e}var Tr=class extends Rr{constructor(e,t,n){super(e,t,n),Object.assign(this,{orbit:new Gn,lighting:new Sr,labels:{},ground:!1,scene:null,isTouched:!1}),Object.assign(this,{opened:null,shown:null,loading:null,lit:Promise.resolve(),placing:Promise.resolve()})}close(){this.loading?.abort(),this.end()}async open(e){this.loading?.abort();let t=this.loading=new AbortController,{signal:n}=t;try{this.notices.say(null,!1,"asset"),this.tell("loading");let s=(f,h)=>n.aborted||this.tell("progress",{got:f,all:h}),i=e instanceof Blob?new Tt(e,e.name):await Un.open(e,s,n,this.labels[rn(e)]),o=await jt.open(i);n.throwIfAborted(),o.environment&&this.settings.firstLook!=="off"&&this.lit.then(()=>this.lighting.prepare());let c=this.settings.tier,l=this._known(o,c);await this.begun&&o.prefetch(l,this.settings.firstLook!=="off"),await this._offerPoster(o),await this._show(o,l,!0,n),this.settings.tier!==c&&await this._show(o,this._known(o,this.settings.tier),!1,n)}catch(s){n.aborted||this.failed(s,"asset")}finally{this.loading===t&&(this.loading=null,this.tell("ended"))}}async switchTier(e){try{this.notices.say(null,!1,"asset"),await this._show(this.opened,this._known(this.opened,e),!1)}catch(t){this.failed(t,"asset")}finally{this.tell("ended")}}_known({manifest:e},t){let n=e.tiers.map(i=>i.name),s=t===null||n.includes(t);return this.notices.say(s?null:`tier: expected ${n.join(" or ")}, found ${JSON.stringify(t)}`,!0,"tier"),s?t:null}async openScene(e){try{let t=fh(await Ws(e),e),{radiance:n,image:s}=t.environment??{},i=o=>new URL(ro(o),new URL(e,document.baseURI)).href;if(t.asset&&(t.asset=i(t.asset)),n&&(t.environment.key=this.lighting.add("The scene's",rr(n))),s){let o=this.labels[s]??s;t.environment.key=this.lighting.add(o,ys(await Ws(i(s)),s))}return this.scene=t,this.reset(),t}catch(t){return this.failed(t,"scene"),null}}leaveScene(){this.scene=null,this.reset()}openImage(e,t){return this.lit=this._openImage(e,t)}async _openImage(e,t){let n=this.requestedImage={};try{this.notices.say(null,!1,"light");let s=e instanceof Blob?await e.arrayBuffer():await Ws(e);if(n!==this.requestedImage)return;this.setLight({choice:this.lighting.add(this.labels[t]??t,ys(s,t))})}catch(s){n===this.requestedImage&&this.failed(s,"light")}}chooseImage(e){this.requestedImage=null,this.setLight({choice:e})}setLight(e,{moving:t=!1,byUser:n=!1}={}){Object.assign(this.lighting,e),this.tell("set"),this.tell("light",{byUser:n}),this.changed(t)}changed(e=!1,t=void 0){if(!this.viewer)return;if(this.engine.hasLobes&&!this.lighting.isPrepared)return void this.lighting.prepare().then(()=>this.changed(e,t));let{lights:n,irradiance:s}=this.lighting.lights();n.some(({kind:i})=>i==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.lights=n,this.viewer.firstLights=this.engine.hasLobes?this.lighting.firstLights():null,this.viewer.ground=this._ground(s),this.viewer.restart(e,t)}reset(){let{ground:e,exposure:t,view:n}=this.scene??{},{settings:s}=this;this.placeCamera(),this.placeLights(),this.ground=s.ground??e??this.ground,this.setExposure(s.exposure??t??this.look.exposure),this.setView(s.viewTransform??n??this.look.view)}placeCamera(){let{position:e,look_at:t,vertical_fov_deg:n}=this.scene?.camera??{},{settings:s}=this,i=[e?hi(e,t,n):{},s.cameraOrbit??{},{target:s.cameraTarget,fov:s.fieldOfView}];this.isTouched=!1,this.orbit.limits=Dr(s);let{width:o,height:c}=this.canvas??{width:1,height:1};this.orbit.place(i,this.box,o/c),this.tell("camera",{byUser:!1}),this.viewer?.restart()}limitCamera(){this.orbit.limits=Dr(this.settings),this.orbit.limit(),this.tell("camera",{byUser:!1}),this.viewer?.restart()}hitAt(e,t){let n=this.viewer?.shownCamera;return n&&this.arrays?Kn(this.arrays,n.position,Ai(n,e,t)):null}placeLights(){let{suns:e,environment:t}=this.scene??{},{sun:n,lightRotation:s,environmentIntensity:i}=this.settings,{lighting:o}=this;if(o.reset(),e&&(o.suns=e),t){let{key:c,strength:l=1,rotation_deg:f=0}=t,h=!this.settings.environment&&c||o.choice;Object.assign(o,{choice:h,strength:l,imageTurn:f})}n&&Object.assign(o,n,{suns:null}),this.setLight({rotation:Hn(s??0),strength:i??o.strength})}turnTable(e,t){this.orbit.turntable=-e,this.lighting.turntable=-e*180/Math.PI,this.changed(t,4)}setExposure(e,t=!0){this._setLook({exposure:e},t&&this.ground)}setView(e){this._setLook({view:e},this.ground)}setBackdrop(e){this._setLook({backdrop:e},this.ground)}setDenoise(e){this._setLook({denoise:e})}setSampling(e){this._setLook(e),this.viewer?.restart()}setGround(e){this.ground=e,this.changed()}_setLook(e,t=!1){Object.assign(this.look,e),Object.assign(this.viewer??{},e),this.tell("set"),t&&this.changed(),this.viewer?.show()}async _show(e,t,n,s){if(!await this.begun)return;let i=await e.load(t,{wantsLobes:this.settings.firstLook!=="off"});e.forget(),performance.mark("package"),await this.lit,await this.begun&&(this.placing=this.placing.catch(()=>{}).then(()=>this._place(e,i,n,s)),await this.placing)}async _place(e,t,n,s){if(s?.throwIfAborted(),!this.viewer||!n&&this.opened!==e)return;n&&(this.viewer.hasShown=!1),this.viewer.pause();let i=n?nr(t.parts):this.arrays;if(!await this._upload(i,t))return;let o=await i;this.engine.hasLobes&&await this.lighting.prepare(),s?.throwIfAborted(),performance.mark("asset"),Object.assign(this,{opened:e,shown:t,arrays:o,box:o.box,isNew:n}),n&&this.scene?this.reset():n&&this.placeCamera();let{warnings:c}=e.manifest;c.length&&this.notices.say(c.join("; "),!0,"asset"),this.tell("package",{opened:e,shown:t}),this.viewer.stats.ms=0,this.changed(),this.viewer.start()}async _upload(e,{parts:t}){for(;await this.begun&&this.engine;){let{engine:n}=this;try{if(await n.setAsset(e,t),n===this.engine)return!0}catch(s){if(n===this.engine)throw s}}return!1}async restore(e){this.uploaded=null,this.shown&&(this.viewer.hasShown=!0,await e.setAsset(this.arrays,this.shown.parts),this.changed(),this.viewer?.start())}resized(){this.shown&&!this.isTouched&&this.placeCamera()}pictured(){this.tell("shown"),!(!this.isNew||!this.viewer.stats.isSharp)&&(this.isNew=!1,this.tell("load"))}async _offerPoster(e){try{this.tell("poster",{blob:await e.posterImage()})}catch{}}_ground(e){let{view:t,exposure:n,backdrop:s}=this.look;if(this.notices.say(this.ground&&!s?"ground: expected an opaque background-color":null,!0,"ground"),!this.ground||!s||!this.box)return null;let i=t==="filmic"?Ca(s):s,{min:o,max:c}=this.box,l=Math.hypot(...c.map((f,h)=>f-o[h]));return{height:o[1]-1e-4*l,x:(o[0]+c[0])/2,z:(o[2]+c[2])/2,size:2*l,colour:i.map((f,h)=>e[h]>0?f/e[h]/2**n:0)}}};function fh(r,e){try{return JSON.parse(new TextDecoder().decode(r))}catch(t){throw new G(`${e}: expected a scene.json, found ${Lt(new Uint8Array(r))??t.message}`)}}async function Ws(r){let e=await fetch(r).catch(()=>null);if(!e?.ok)throw new G(`cannot load ${r}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var Ir=class{constructor(e){Object.assign(this,{stage:e,angle:0,isOn:!1,isTurning:!1,delay:3e3,speed:30}),e.addEventListener("shown",()=>this._next());for(let t of["load","camera","light"])e.addEventListener(t,()=>this.wait())}wait(){clearTimeout(this.timer);let e=this.isTurning;this.isTurning=!1,this.isOn?this.timer=setTimeout(()=>this._start(),this.delay):e&&this.stage.viewer?.restart()}switch(e){this.isOn=e,this.wait()}set(e){this.angle=e,this.stage.turnTable(e,this.isTurning)}_start(){Object.assign(this,{isTurning:!0,last:performance.now()}),this._next()}_next(){!this.isTurning||this.isRequested||(this.isRequested=!0,requestAnimationFrame(e=>{if(this.isRequested=!1,!this.isTurning)return;let t=Math.min(.25,Math.max(0,e-this.last)/1e3);this.last=e,this.set(this.angle+t*this.speed*Math.PI/180)}))}};var hh=["studio","white"],ph="50% 0px",mh=500,dh=3e3,gh={src:"asset",environment:"light",scene:"scene"},Nr=class{constructor(e,t,n){Object.assign(this,{x:e,y:t,z:n})}toString(){return[this.x,this.y,this.z].map(e=>`${e}m`).join(" ")}},Or=class extends(globalThis.HTMLElement??Object){static observedAttributes=Object.keys(an);constructor(){super();let e=Ei(this),t=n=>e.getElementById(n);this.parts={view:t("view"),poster:t("poster"),image:e.querySelector("img"),loading:t("loading"),prompt:t("prompt"),bar:t("bar"),bytes:t("bytes"),status:t("status"),tint:t("tint")},this.settings=Object.fromEntries(Object.keys(an).map(n=>[Yn(n),null])),this.notices=new Dn(t("notice")),this.stage=new Tr(this.parts.view,this.notices,this.settings),this.stage.look.isCovered=()=>this._isCovered,this.turntable=new Ir(this.stage),new Jn(this,t("hotspots"),this.stage),this.stillness=matchMedia("(prefers-reduced-motion: reduce)"),Object.assign(this,{loaded:!1,observer:null,isNear:!1,isFound:!1,isDismissed:!1,isBegun:!1,asked:null,failures:new Set}),this._listen()}connectedCallback(){this.stage.labels=JSON.parse(this.dataset.labels??"{}"),this.observer=new IntersectionObserver(e=>this._seen(e.at(-1).isIntersecting),{rootMargin:ph}),this.observer.observe(this),this.stillness.addEventListener("change",this.onstillness=()=>this._still()),this._turn(),this._tint(),this._begin()}disconnectedCallback(){this.observer.disconnect(),this.stillness.removeEventListener("change",this.onstillness),queueMicrotask(()=>{this.isConnected||!this.isBegun||(this.stage.loading&&(this.asked=null),this.isBegun=!1,this.turntable.switch(!1),this.stage.close())})}attributeChangedCallback(e,t,n){let s=this.failures.delete(gh[e]);if(t===n&&!s)return;e==="src"&&(this.asked=null);let i=Yn(e);try{this.settings[i]=n===null?null:an[e](n),this.notices.say(null,!0,e)}catch(o){this.settings[i]=null,this.notices.say(`${e}: ${o.message}`,!0,e)}this._apply(e)}get availableTiers(){return this.stage.opened?.manifest.tiers.map(({name:e})=>e)??[]}get turntableRotation(){return this.turntable.angle}resetTurntableRotation(e=0){this.turntable.set(e)}resetView(){this.stage.reset()}showPoster(){this.isDismissed=!1,this.parts.poster.hidden=!1}dismissPoster(){this.isDismissed=!0,this._begin(),this.loaded&&this._hidePoster()}positionAndNormalFromPoint(e,t){let{left:n,top:s,width:i,height:o}=this.parts.view.getBoundingClientRect(),c=this.stage.hitAt((e-n)/i,(t-s)/o);return c&&{position:new Nr(...c.position),normal:new Nr(...c.normal)}}async toBlob({mimeType:e="image/png",qualityArgument:t,converged:n=!1}={}){let{stage:s}=this;return!s.viewer||!this.loaded?null:(n&&await s.viewer.converged(),s.screenshot(e,t))}_seen(e){this.isNear=e,this.stage.rest(!e),this._tint(),this._begin()}_apply(e){let{stage:t,settings:n}=this;e==="src"&&this._begin(),e==="poster"&&this._showImage(n.poster),e==="scene"&&this.isBegun&&this._openScene(),e==="environment"&&this.isBegun&&this._light(),e==="tier"&&t.opened&&!t.loading&&t.switchTier(n.tier),e==="first-look"&&t.shown&&t.switchTier(t.shown.name),e==="samples"&&t.setSampling({rounds:n.samples??256}),e==="jitter"&&t.setSampling({jitter:n.jitter??1}),["camera-orbit","camera-target","field-of-view"].includes(e)&&t.placeCamera(),/^(min|max)-/.test(e)&&t.limitCamera(),["sun","light-rotation","environment-intensity"].includes(e)&&t.placeLights(),e==="ground"&&t.setGround(n.ground??t.scene?.ground??!1),e==="exposure"&&t.setExposure(n.exposure??t.scene?.exposure??0),e==="view-transform"&&t.setView(n.viewTransform??t.scene?.view??"srgb"),e==="pixel-ratio"&&t.resize(),["loading","reveal"].includes(e)&&this._begin(),["camera-controls","interaction-prompt"].includes(e)&&this._prompt(),(e.startsWith("auto-rotate")||e==="rotation-per-second")&&this._turn(),this._describe()}_begin(){let{stage:e,settings:t}=this,n=t.reveal!=="manual"||this.isDismissed;if(this.parts.image.loading=t.loading==="eager"?"eager":"lazy",!(!this.isConnected||!this.observer||!(t.loading==="eager"||this.isNear&&n))){if(!this.isBegun&&(this.isBegun=!0,e.begin(),this._turn(),t.environment&&!this.isLit&&this._light(),t.scene))return void this._openScene();t.src!==this.asked&&this._open()}}_open(){this.asked=this.settings.src,this.asked!==null&&(this.loaded=!1,this.stage.open(this.asked))}async _openScene(){let e=this.requestedScene=this.settings.scene;if(e===null)return this.stage.leaveScene();let t=await this.stage.openScene(e);e===this.requestedScene&&(this.settings.src?this._begin():t?.asset&&this.stage.open(t.asset))}_light(){let{environment:e}=this.settings;this.isLit=!0,e!==null&&!hh.includes(e)?this.stage.openImage(e,rn(e)):this.stage.chooseImage(e??"studio")}_tint(){this.stage.setBackdrop(di(getComputedStyle(this.parts.tint).backgroundColor))}_still(){this._turn(),this._prompt()}_turn(){let{autoRotate:e,autoRotateDelay:t,rotationPerSecond:n}=this.settings;Object.assign(this.turntable,{delay:t??3e3,speed:n??30}),this.turntable.switch(!!e&&this.isBegun&&!this.stillness.matches)}_listen(){let{stage:e,parts:t}=this,n=(s,i)=>e.addEventListener(s,i);t.tint.addEventListener("transitionend",()=>this._tint()),n("engine",()=>this._describe()),n("progress",({got:s,all:i})=>this._showProgress(s,i)),n("poster",({blob:s})=>this.settings.poster||this._showImage(s&&URL.createObjectURL(s))),n("package",()=>this._describe()),n("loading",()=>this.failures.delete("asset")),n("load",()=>{this.loaded=!0,(this.settings.reveal!=="manual"||this.isDismissed)&&this._hidePoster(),t.status.textContent=`${this._name()} is shown`,this._fire("progress",{totalProgress:1}),this._fire("load",{url:this.asked}),this._prompt()}),n("ended",()=>{t.loading.hidden=!0}),n("failed",({error:s,about:i})=>{this.failures.add(i),i==="engine"&&(t.poster.hidden=!1),this._fire("error",{type:i,message:s.message,code:s.code??null,sourceError:s})}),n("camera",({byUser:s})=>{this._fire("camera-change",{...cn(e.orbit),source:s?"user-interaction":"none"}),s&&(this._found(),this._speak())}),n("light",({byUser:s})=>this._fire("light-change",{...Wn(e.lighting),source:s?"user-interaction":"none"}))}_prompt(){clearTimeout(this.prompting);let{cameraControls:e,interactionPrompt:t}=this.settings,n=()=>e&&t!=="none"&&!this.isFound&&!this.stillness.matches;this.parts.prompt.hidden=!0,this.loaded&&n()&&(this.prompting=setTimeout(()=>{this.parts.prompt.hidden=!n()},dh))}_found(){this.isFound=!0,this._prompt()}_speak(){clearTimeout(this.speaking),this.speaking=setTimeout(()=>{this.parts.status.textContent=ki(this.stage.orbit)},mh)}_showProgress(e,t){let{loading:n,bar:s,bytes:i}=this.parts;n.hidden=!1,t?Object.assign(s,{max:Math.max(t,e),value:e}):s.removeAttribute("value"),i.textContent=t?`${dt(e)} of ${dt(Math.max(t,e))}`:dt(e),this._fire("progress",{totalProgress:t?Math.min(.99,e/t):0})}_showImage(e){let{image:t,poster:n}=this.parts;t.src.startsWith("blob:")&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=e:t.removeAttribute("src"),e&&(n.hidden=!1)}get _isCovered(){let{poster:e,image:t}=this.parts;return!e.hidden&&(!t.hidden||e.firstChild.assignedElements().length>0)}_hidePoster(){let{poster:e}=this.parts;e.hidden||(e.hidden=!0,this._fire("poster-dismissed"))}_name(){return this.settings.alt??this.stage.opened?.manifest.name??"A relightable asset"}_describe(){let{canvas:e}=this.stage,{cameraControls:t,touchAction:n}=this.settings;if(this.parts.image.alt=this._name(),!e)return;e.style.touchAction=t?n??"pan-y":"auto";let s=t?{role:"application",tabindex:0,"aria-describedby":"keys"}:{role:"img"};e.setAttribute("aria-label",this._name());for(let i of["role","tabindex","aria-describedby"])i in s?e.setAttribute(i,s[i]):e.removeAttribute(i)}_fire(e,t=null){this.dispatchEvent(new CustomEvent(e,{detail:t}))}},_h={cameraOrbit:({stage:r})=>cn(r.orbit).cameraOrbit,cameraTarget:({stage:r})=>cn(r.orbit).cameraTarget,fieldOfView:({stage:r})=>cn(r.orbit).fieldOfView,sun:({stage:r})=>Wn(r.lighting).sun,lightRotation:({stage:r})=>Wn(r.lighting).lightRotation,environmentIntensity:({stage:r})=>r.lighting.strength,exposure:({stage:r})=>r.look.exposure,viewTransform:({stage:r})=>r.look.view,tier:({stage:r,settings:e})=>r.shown?.name??e.tier};for(let[r,e]of Object.entries(an)){let t=Yn(r),n=e===Ke;Object.defineProperty(Or.prototype,t,{get(){return _h[t]?.(this)??(n?this.settings[t]===!0:this.settings[t])},set(s){n?this.toggleAttribute(r,!!s):s==null?this.removeAttribute(r):this.setAttribute(r,s)},enumerable:!0,configurable:!0})}globalThis.customElements&&!customElements.get("rna-viewer")&&customElements.define("rna-viewer",Or);})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
