var Do=1;var Uo=3;var Zs=0,Js=1,Ks=2,js=3,Qs=4,tr=5,er=6,nr=7,Oo=0,Fo=1,Bo=2;var xr=1,vr=2,yr=3,Sr=4,Mr=5,br=6,wr=7;var Er=300;var zo=302;var ir=1e3,rn=1001,sr=1002,rr=1003;var ce=1006;var Ar=1008;var ko=1009;var ue=1015,fe=1016;var ye=1023;var Cn=1028;var hn=1030;var ri=2300,Wi=2301,Gi=2302,or=2303,ar=2400,lr=2401,cr=2402;var Tr="",ie="srgb",Jt="srgb-linear",hr="linear",Hi="srgb";var Go=35044;var si=2e3,ur=2001;function cc(r){for(let t=r.length-1;t>=0;--t)if(r[t]>=65535)return!0;return!1}function hc(r){return ArrayBuffer.isView(r)&&!(r instanceof DataView)}function fr(r){return document.createElementNS("http://www.w3.org/1999/xhtml",r)}var vo={},Xi=null;function Ho(r){let t=r[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=r[1];e&&e.isStackTrace?r[0]+=" "+e.getLocation():r[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return r}function At(...r){r=Ho(r);let t="THREE."+r.shift();if(Xi)Xi("warn",t,...r);else{let e=r[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...r)}}function vt(...r){r=Ho(r);let t="THREE."+r.shift();if(Xi)Xi("error",t,...r);else{let e=r[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...r)}}function Vi(...r){let t=r.join(" ");t in vo||(vo[t]=!0,At(...r))}var uc={[Zs]:Zs,[Ks]:er,[Qs]:Qs,[js]:tr,[Js]:Js,[er]:Ks,[nr]:nr,[tr]:js},on=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let i=n[t];if(i!==void 0){let s=i.indexOf(e);s!==-1&&i.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let i=n.slice(0);for(let s=0,o=i.length;s<o;s++)i[s].call(this,t);t.target=null}}},Ot=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var tm=Math.PI/180,fc=180/Math.PI;function cs(){let r=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ot[r&255]+Ot[r>>8&255]+Ot[r>>16&255]+Ot[r>>24&255]+"-"+Ot[t&255]+Ot[t>>8&255]+"-"+Ot[t>>16&15|64]+Ot[t>>24&255]+"-"+Ot[e&63|128]+Ot[e>>8&255]+"-"+Ot[e>>16&255]+Ot[e>>24&255]+Ot[n&255]+Ot[n>>8&255]+Ot[n>>16&255]+Ot[n>>24&255]).toLowerCase()}function ct(r,t,e){return Math.max(t,Math.min(e,r))}function dc(r,t){return(r%t+t)%t}function zs(r,t,e){return(1-e)*r+e*t}function Rr(r){switch(r.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function pc(r,t){if(t.constructor===Float32Array)return r;let e=Rr(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(r/e,-1)}function mc(r,t){if(t.constructor===Float32Array)return r;let e=Rr(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(r*e)}var kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,i=t.elements;return this.x=i[0]*e+i[3]*n+i[6],this.y=i[1]*e+i[4]*n+i[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ct(this.x,t.x,e.x),this.y=ct(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ct(this.x,t,e),this.y=ct(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ct(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),i=Math.sin(e),s=this.x-t.x,o=this.y-t.y;return this.x=s*n-o*i+t.x,this.y=s*i+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ne=class{constructor(t=0,e=0,n=0,i=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=i}static slerpFlat(t,e,n,i,s,o,a){let c=n[i+0],l=n[i+1],u=n[i+2],f=n[i+3],p=s[o+0],m=s[o+1],_=s[o+2],v=s[o+3];if(f!==v||c!==p||l!==m||u!==_){let b=c*p+l*m+u*_+f*v;b<0&&(p=-p,m=-m,_=-_,v=-v,b=-b);let w=1-a;if(b<.9995){let T=Math.acos(b),N=Math.sin(T);w=Math.sin(w*T)/N,a=Math.sin(a*T)/N,c=c*w+p*a,l=l*w+m*a,u=u*w+_*a,f=f*w+v*a}else{c=c*w+p*a,l=l*w+m*a,u=u*w+_*a,f=f*w+v*a;let T=1/Math.sqrt(c*c+l*l+u*u+f*f);c*=T,l*=T,u*=T,f*=T}}t[e]=c,t[e+1]=l,t[e+2]=u,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,i,s,o){let a=n[i],c=n[i+1],l=n[i+2],u=n[i+3],f=s[o],p=s[o+1],m=s[o+2],_=s[o+3];return t[e]=a*_+u*f+c*m-l*p,t[e+1]=c*_+u*p+l*f-a*m,t[e+2]=l*_+u*m+a*p-c*f,t[e+3]=u*_-a*f-c*p-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,i){return this._x=t,this._y=e,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,i=t._y,s=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(i/2),f=a(s/2),p=c(n/2),m=c(i/2),_=c(s/2);switch(o){case"XYZ":this._x=p*u*f+l*m*_,this._y=l*m*f-p*u*_,this._z=l*u*_+p*m*f,this._w=l*u*f-p*m*_;break;case"YXZ":this._x=p*u*f+l*m*_,this._y=l*m*f-p*u*_,this._z=l*u*_-p*m*f,this._w=l*u*f+p*m*_;break;case"ZXY":this._x=p*u*f-l*m*_,this._y=l*m*f+p*u*_,this._z=l*u*_+p*m*f,this._w=l*u*f-p*m*_;break;case"ZYX":this._x=p*u*f-l*m*_,this._y=l*m*f+p*u*_,this._z=l*u*_-p*m*f,this._w=l*u*f+p*m*_;break;case"YZX":this._x=p*u*f+l*m*_,this._y=l*m*f+p*u*_,this._z=l*u*_-p*m*f,this._w=l*u*f-p*m*_;break;case"XZY":this._x=p*u*f-l*m*_,this._y=l*m*f-p*u*_,this._z=l*u*_+p*m*f,this._w=l*u*f+p*m*_;break;default:At("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,i=Math.sin(n);return this._x=t.x*i,this._y=t.y*i,this._z=t.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],i=e[4],s=e[8],o=e[1],a=e[5],c=e[9],l=e[2],u=e[6],f=e[10],p=n+a+f;if(p>0){let m=.5/Math.sqrt(p+1);this._w=.25/m,this._x=(u-c)*m,this._y=(s-l)*m,this._z=(o-i)*m}else if(n>a&&n>f){let m=2*Math.sqrt(1+n-a-f);this._w=(u-c)/m,this._x=.25*m,this._y=(i+o)/m,this._z=(s+l)/m}else if(a>f){let m=2*Math.sqrt(1+a-n-f);this._w=(s-l)/m,this._x=(i+o)/m,this._y=.25*m,this._z=(c+u)/m}else{let m=2*Math.sqrt(1+f-n-a);this._w=(o-i)/m,this._x=(s+l)/m,this._y=(c+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ct(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let i=Math.min(1,e/n);return this.slerp(t,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,i=t._y,s=t._z,o=t._w,a=e._x,c=e._y,l=e._z,u=e._w;return this._x=n*u+o*a+i*l-s*c,this._y=i*u+o*c+s*a-n*l,this._z=s*u+o*l+n*c-i*a,this._w=o*u-n*a-i*c-s*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,i=t._y,s=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,i=-i,s=-s,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,e=Math.sin(e*l)/u,this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+s*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+s*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(i*Math.sin(t),i*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},$=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(yo.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(yo.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*i,this.y=s[1]*e+s[4]*n+s[7]*i,this.z=s[2]*e+s[5]*n+s[8]*i,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=t.elements,o=1/(s[3]*e+s[7]*n+s[11]*i+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*i+s[12])*o,this.y=(s[1]*e+s[5]*n+s[9]*i+s[13])*o,this.z=(s[2]*e+s[6]*n+s[10]*i+s[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,i=this.z,s=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*i-a*n),u=2*(a*e-s*i),f=2*(s*n-o*e);return this.x=e+c*l+o*f-a*u,this.y=n+c*u+a*l-s*f,this.z=i+c*f+s*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*i,this.y=s[1]*e+s[5]*n+s[9]*i,this.z=s[2]*e+s[6]*n+s[10]*i,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ct(this.x,t.x,e.x),this.y=ct(this.y,t.y,e.y),this.z=ct(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ct(this.x,t,e),this.y=ct(this.y,t,e),this.z=ct(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,i=t.y,s=t.z,o=e.x,a=e.y,c=e.z;return this.x=i*c-s*a,this.y=s*o-n*c,this.z=n*a-i*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return ks.copy(this).projectOnVector(t),this.sub(ks)}reflect(t){return this.sub(ks.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ct(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,i=this.z-t.z;return e*e+n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let i=Math.sin(e)*t;return this.x=i*Math.sin(n),this.y=Math.cos(e)*t,this.z=i*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),i=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=i,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ks=new $,yo=new Ne,ot=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,i,s,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,o,a,c,l)}set(t,e,n,i,s,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=i,u[2]=a,u[3]=e,u[4]=s,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],f=n[7],p=n[2],m=n[5],_=n[8],v=i[0],b=i[3],w=i[6],T=i[1],N=i[4],D=i[7],U=i[2],Y=i[5],X=i[8];return s[0]=o*v+a*T+c*U,s[3]=o*b+a*N+c*Y,s[6]=o*w+a*D+c*X,s[1]=l*v+u*T+f*U,s[4]=l*b+u*N+f*Y,s[7]=l*w+u*D+f*X,s[2]=p*v+m*T+_*U,s[5]=p*b+m*N+_*Y,s[8]=p*w+m*D+_*X,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return e*o*u-e*a*l-n*s*u+n*a*c+i*s*l-i*o*c}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],f=u*o-a*l,p=a*c-u*s,m=l*s-o*c,_=e*f+n*p+i*m;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return t[0]=f*v,t[1]=(i*l-u*n)*v,t[2]=(a*n-i*o)*v,t[3]=p*v,t[4]=(u*e-i*c)*v,t[5]=(i*s-a*e)*v,t[6]=m*v,t[7]=(n*c-l*e)*v,t[8]=(o*e-n*s)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,i,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-i*l,i*c,-i*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Vi("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Gs.makeScale(t,e)),this}rotate(t){return Vi("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Gs.makeRotation(-t)),this}translate(t,e){return Vi("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Gs.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<9;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Gs=new ot,So=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Mo=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gc(){let r={enabled:!0,workingColorSpace:Jt,spaces:{},convert:function(i,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Hi&&(i.r=Le(i.r),i.g=Le(i.g),i.b=Le(i.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(i.applyMatrix3(this.spaces[s].toXYZ),i.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Hi&&(i.r=Tn(i.r),i.g=Tn(i.g),i.b=Tn(i.b))),i},workingToColorSpace:function(i,s){return this.convert(i,this.workingColorSpace,s)},colorSpaceToWorking:function(i,s){return this.convert(i,s,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Tr?hr:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,s=this.workingColorSpace){return i.fromArray(this.spaces[s].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,s,o){return i.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return r.define({[Jt]:{primaries:t,whitePoint:n,transfer:hr,toXYZ:So,fromXYZ:Mo,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ie},outputColorSpaceConfig:{drawingBufferColorSpace:ie}},[ie]:{primaries:t,whitePoint:n,transfer:Hi,toXYZ:So,fromXYZ:Mo,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ie}}}),r}var ne=gc();function Le(r){return r<.04045?r*.0773993808:Math.pow(r*.9478672986+.0521327014,2.4)}function Tn(r){return r<.0031308?r*12.92:1.055*Math.pow(r,.41666)-.055}var xn,$i=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xn===void 0&&(xn=fr("canvas")),xn.width=t.width,xn.height=t.height;let i=xn.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=xn}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=fr("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let i=n.getImageData(0,0,t.width,t.height),s=i.data;for(let o=0;o<s.length;o++)s[o]=Le(s[o]/255)*255;return n.putImageData(i,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Le(e[n]/255)*255):e[n]=Le(e[n]);return{data:e,width:t.width,height:t.height}}else return At("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},_c=0,qi=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:_c++}),this.uuid=cs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let s;if(Array.isArray(i)){s=[];for(let o=0,a=i.length;o<a;o++)i[o].isDataTexture?s.push(Hs(i[o].image)):s.push(Hs(i[o]))}else s=Hs(i);n.url=s}return e||(t.images[this.uuid]=n),n}};function Hs(r){return typeof HTMLImageElement<"u"&&r instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&r instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&r instanceof ImageBitmap?$i.getDataURL(r):r.data?{data:Array.from(r.data),width:r.width,height:r.height,type:r.data.constructor.name}:(At("Texture: Unable to serialize Texture."),{})}var xc=0,Vs=new $,an=class r extends on{constructor(t=r.DEFAULT_IMAGE,e=r.DEFAULT_MAPPING,n=rn,i=rn,s=ce,o=Ar,a=ye,c=ko,l=r.DEFAULT_ANISOTROPY,u=Tr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:xc++}),this.uuid=cs(),this.name="",this.source=new qi(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new kt(0,0),this.repeat=new kt(1,1),this.center=new kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Vs).x}get height(){return this.source.getSize(Vs).y}get depth(){return this.source.getSize(Vs).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){At(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){At(`Texture.setValues(): property '${e}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Er)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ir:t.x=t.x-Math.floor(t.x);break;case rn:t.x=t.x<0?0:1;break;case sr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ir:t.y=t.y-Math.floor(t.y);break;case rn:t.y=t.y<0?0:1;break;case sr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};an.DEFAULT_IMAGE=null;an.DEFAULT_MAPPING=Er;an.DEFAULT_ANISOTROPY=1;var dr=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,i=1){this.x=t,this.y=e,this.z=n,this.w=i}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,i){return this.x=t,this.y=e,this.z=n,this.w=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*i+o[12]*s,this.y=o[1]*e+o[5]*n+o[9]*i+o[13]*s,this.z=o[2]*e+o[6]*n+o[10]*i+o[14]*s,this.w=o[3]*e+o[7]*n+o[11]*i+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,i,s,c=t.elements,l=c[0],u=c[4],f=c[8],p=c[1],m=c[5],_=c[9],v=c[2],b=c[6],w=c[10];if(Math.abs(u-p)<.01&&Math.abs(f-v)<.01&&Math.abs(_-b)<.01){if(Math.abs(u+p)<.1&&Math.abs(f+v)<.1&&Math.abs(_+b)<.1&&Math.abs(l+m+w-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let N=(l+1)/2,D=(m+1)/2,U=(w+1)/2,Y=(u+p)/4,X=(f+v)/4,O=(_+b)/4;return N>D&&N>U?N<.01?(n=0,i=.707106781,s=.707106781):(n=Math.sqrt(N),i=Y/n,s=X/n):D>U?D<.01?(n=.707106781,i=0,s=.707106781):(i=Math.sqrt(D),n=Y/i,s=O/i):U<.01?(n=.707106781,i=.707106781,s=0):(s=Math.sqrt(U),n=X/s,i=O/s),this.set(n,i,s,e),this}let T=Math.sqrt((b-_)*(b-_)+(f-v)*(f-v)+(p-u)*(p-u));return Math.abs(T)<.001&&(T=1),this.x=(b-_)/T,this.y=(f-v)/T,this.z=(p-u)/T,this.w=Math.acos((l+m+w-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ct(this.x,t.x,e.x),this.y=ct(this.y,t.y,e.y),this.z=ct(this.z,t.z,e.z),this.w=ct(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ct(this.x,t,e),this.y=ct(this.y,t,e),this.z=ct(this.z,t,e),this.w=ct(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var se=class r{static{this.prototype.isMatrix4=!0}constructor(t,e,n,i,s,o,a,c,l,u,f,p,m,_,v,b){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,o,a,c,l,u,f,p,m,_,v,b)}set(t,e,n,i,s,o,a,c,l,u,f,p,m,_,v,b){let w=this.elements;return w[0]=t,w[4]=e,w[8]=n,w[12]=i,w[1]=s,w[5]=o,w[9]=a,w[13]=c,w[2]=l,w[6]=u,w[10]=f,w[14]=p,w[3]=m,w[7]=_,w[11]=v,w[15]=b,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new r().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,i=1/vn.setFromMatrixColumn(t,0).length(),s=1/vn.setFromMatrixColumn(t,1).length(),o=1/vn.setFromMatrixColumn(t,2).length();return e[0]=n[0]*i,e[1]=n[1]*i,e[2]=n[2]*i,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,i=t.y,s=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(i),l=Math.sin(i),u=Math.cos(s),f=Math.sin(s);if(t.order==="XYZ"){let p=o*u,m=o*f,_=a*u,v=a*f;e[0]=c*u,e[4]=-c*f,e[8]=l,e[1]=m+_*l,e[5]=p-v*l,e[9]=-a*c,e[2]=v-p*l,e[6]=_+m*l,e[10]=o*c}else if(t.order==="YXZ"){let p=c*u,m=c*f,_=l*u,v=l*f;e[0]=p+v*a,e[4]=_*a-m,e[8]=o*l,e[1]=o*f,e[5]=o*u,e[9]=-a,e[2]=m*a-_,e[6]=v+p*a,e[10]=o*c}else if(t.order==="ZXY"){let p=c*u,m=c*f,_=l*u,v=l*f;e[0]=p-v*a,e[4]=-o*f,e[8]=_+m*a,e[1]=m+_*a,e[5]=o*u,e[9]=v-p*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let p=o*u,m=o*f,_=a*u,v=a*f;e[0]=c*u,e[4]=_*l-m,e[8]=p*l+v,e[1]=c*f,e[5]=v*l+p,e[9]=m*l-_,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let p=o*c,m=o*l,_=a*c,v=a*l;e[0]=c*u,e[4]=v-p*f,e[8]=_*f+m,e[1]=f,e[5]=o*u,e[9]=-a*u,e[2]=-l*u,e[6]=m*f+_,e[10]=p-v*f}else if(t.order==="XZY"){let p=o*c,m=o*l,_=a*c,v=a*l;e[0]=c*u,e[4]=-f,e[8]=l*u,e[1]=p*f+v,e[5]=o*u,e[9]=m*f-_,e[2]=_*f-m,e[6]=a*u,e[10]=v*f+p}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(vc,t,yc)}lookAt(t,e,n){let i=this.elements;return Yt.subVectors(t,e),Yt.lengthSq()===0&&(Yt.z=1),Yt.normalize(),ke.crossVectors(n,Yt),ke.lengthSq()===0&&(Math.abs(n.z)===1?Yt.x+=1e-4:Yt.z+=1e-4,Yt.normalize(),ke.crossVectors(n,Yt)),ke.normalize(),Ni.crossVectors(Yt,ke),i[0]=ke.x,i[4]=Ni.x,i[8]=Yt.x,i[1]=ke.y,i[5]=Ni.y,i[9]=Yt.y,i[2]=ke.z,i[6]=Ni.z,i[10]=Yt.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],f=n[5],p=n[9],m=n[13],_=n[2],v=n[6],b=n[10],w=n[14],T=n[3],N=n[7],D=n[11],U=n[15],Y=i[0],X=i[4],O=i[8],L=i[12],k=i[1],F=i[5],B=i[9],et=i[13],W=i[2],j=i[6],it=i[10],St=i[14],zt=i[3],_t=i[7],Rt=i[11],_e=i[15];return s[0]=o*Y+a*k+c*W+l*zt,s[4]=o*X+a*F+c*j+l*_t,s[8]=o*O+a*B+c*it+l*Rt,s[12]=o*L+a*et+c*St+l*_e,s[1]=u*Y+f*k+p*W+m*zt,s[5]=u*X+f*F+p*j+m*_t,s[9]=u*O+f*B+p*it+m*Rt,s[13]=u*L+f*et+p*St+m*_e,s[2]=_*Y+v*k+b*W+w*zt,s[6]=_*X+v*F+b*j+w*_t,s[10]=_*O+v*B+b*it+w*Rt,s[14]=_*L+v*et+b*St+w*_e,s[3]=T*Y+N*k+D*W+U*zt,s[7]=T*X+N*F+D*j+U*_t,s[11]=T*O+N*B+D*it+U*Rt,s[15]=T*L+N*et+D*St+U*_e,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],f=t[6],p=t[10],m=t[14],_=t[3],v=t[7],b=t[11],w=t[15],T=c*m-l*p,N=a*m-l*f,D=a*p-c*f,U=o*m-l*u,Y=o*p-c*u,X=o*f-a*u;return e*(v*T-b*N+w*D)-n*(_*T-b*U+w*Y)+i*(_*N-v*U+w*X)-s*(_*D-v*Y+b*X)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return e*(o*u-a*l)-n*(s*u-a*c)+i*(s*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let i=this.elements;return t.isVector3?(i[12]=t.x,i[13]=t.y,i[14]=t.z):(i[12]=t,i[13]=e,i[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],f=t[9],p=t[10],m=t[11],_=t[12],v=t[13],b=t[14],w=t[15],T=e*a-n*o,N=e*c-i*o,D=e*l-s*o,U=n*c-i*a,Y=n*l-s*a,X=i*l-s*c,O=u*v-f*_,L=u*b-p*_,k=u*w-m*_,F=f*b-p*v,B=f*w-m*v,et=p*w-m*b,W=T*et-N*B+D*F+U*k-Y*L+X*O;if(W===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let j=1/W;return t[0]=(a*et-c*B+l*F)*j,t[1]=(i*B-n*et-s*F)*j,t[2]=(v*X-b*Y+w*U)*j,t[3]=(p*Y-f*X-m*U)*j,t[4]=(c*k-o*et-l*L)*j,t[5]=(e*et-i*k+s*L)*j,t[6]=(b*D-_*X-w*N)*j,t[7]=(u*X-p*D+m*N)*j,t[8]=(o*B-a*k+l*O)*j,t[9]=(n*k-e*B-s*O)*j,t[10]=(_*Y-v*D+w*T)*j,t[11]=(f*D-u*Y-m*T)*j,t[12]=(a*L-o*F-c*O)*j,t[13]=(e*F-n*L+i*O)*j,t[14]=(v*N-_*U-b*T)*j,t[15]=(u*U-f*N+p*T)*j,this}scale(t){let e=this.elements,n=t.x,i=t.y,s=t.z;return e[0]*=n,e[4]*=i,e[8]*=s,e[1]*=n,e[5]*=i,e[9]*=s,e[2]*=n,e[6]*=i,e[10]*=s,e[3]*=n,e[7]*=i,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],i=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,i))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),i=Math.sin(e),s=1-n,o=t.x,a=t.y,c=t.z,l=s*o,u=s*a;return this.set(l*o+n,l*a-i*c,l*c+i*a,0,l*a+i*c,u*a+n,u*c-i*o,0,l*c-i*a,u*c+i*o,s*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,i,s,o){return this.set(1,n,s,0,t,1,o,0,e,i,1,0,0,0,0,1),this}compose(t,e,n){let i=this.elements,s=e._x,o=e._y,a=e._z,c=e._w,l=s+s,u=o+o,f=a+a,p=s*l,m=s*u,_=s*f,v=o*u,b=o*f,w=a*f,T=c*l,N=c*u,D=c*f,U=n.x,Y=n.y,X=n.z;return i[0]=(1-(v+w))*U,i[1]=(m+D)*U,i[2]=(_-N)*U,i[3]=0,i[4]=(m-D)*Y,i[5]=(1-(p+w))*Y,i[6]=(b+T)*Y,i[7]=0,i[8]=(_+N)*X,i[9]=(b-T)*X,i[10]=(1-(p+v))*X,i[11]=0,i[12]=t.x,i[13]=t.y,i[14]=t.z,i[15]=1,this}decompose(t,e,n){let i=this.elements;t.x=i[12],t.y=i[13],t.z=i[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let o=vn.set(i[0],i[1],i[2]).length(),a=vn.set(i[4],i[5],i[6]).length(),c=vn.set(i[8],i[9],i[10]).length();s<0&&(o=-o),ae.copy(this);let l=1/o,u=1/a,f=1/c;return ae.elements[0]*=l,ae.elements[1]*=l,ae.elements[2]*=l,ae.elements[4]*=u,ae.elements[5]*=u,ae.elements[6]*=u,ae.elements[8]*=f,ae.elements[9]*=f,ae.elements[10]*=f,e.setFromRotationMatrix(ae),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,i,s,o,a=si,c=!1){let l=this.elements,u=2*s/(e-t),f=2*s/(n-i),p=(e+t)/(e-t),m=(n+i)/(n-i),_,v;if(c)_=s/(o-s),v=o*s/(o-s);else if(a===si)_=-(o+s)/(o-s),v=-2*o*s/(o-s);else if(a===ur)_=-o/(o-s),v=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=p,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=_,l[14]=v,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,i,s,o,a=si,c=!1){let l=this.elements,u=2/(e-t),f=2/(n-i),p=-(e+t)/(e-t),m=-(n+i)/(n-i),_,v;if(c)_=1/(o-s),v=o/(o-s);else if(a===si)_=-2/(o-s),v=-(o+s)/(o-s);else if(a===ur)_=-1/(o-s),v=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=p,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=_,l[14]=v,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<16;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vn=new $,ae=new se,vc=new $(0,0,0),yc=new $(1,1,1),ke=new $,Ni=new $,Yt=new $,bo=new se,wo=new Ne,oi=class r{constructor(t=0,e=0,n=0,i=r.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=i}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,i=this._order){return this._x=t,this._y=e,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let i=t.elements,s=i[0],o=i[4],a=i[8],c=i[1],l=i[5],u=i[9],f=i[2],p=i[6],m=i[10];switch(e){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(p,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(p,-1,1)),Math.abs(p)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(p,m),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ct(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(p,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,m),this._y=0);break;default:At("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return bo.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bo,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return wo.setFromEuler(this),this.setFromQuaternion(wo,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};oi.DEFAULT_ORDER="XYZ";var Yi=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Sc=0,Eo=new $,yn=new Ne,Re=new se,Di=new $,ti=new $,Mc=new $,bc=new Ne,Ao=new $(1,0,0),To=new $(0,1,0),Ro=new $(0,0,1),Co={type:"added"},wc={type:"removed"},Sn={type:"childadded",child:null},Ws={type:"childremoved",child:null},ln=class r extends on{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Sc++}),this.uuid=cs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=r.DEFAULT_UP.clone();let t=new $,e=new oi,n=new Ne,i=new $(1,1,1);function s(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new se},normalMatrix:{value:new ot}}),this.matrix=new se,this.matrixWorld=new se,this.matrixAutoUpdate=r.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=r.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Yi,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yn.setFromAxisAngle(t,e),this.quaternion.multiply(yn),this}rotateOnWorldAxis(t,e){return yn.setFromAxisAngle(t,e),this.quaternion.premultiply(yn),this}rotateX(t){return this.rotateOnAxis(Ao,t)}rotateY(t){return this.rotateOnAxis(To,t)}rotateZ(t){return this.rotateOnAxis(Ro,t)}translateOnAxis(t,e){return Eo.copy(t).applyQuaternion(this.quaternion),this.position.add(Eo.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Ao,t)}translateY(t){return this.translateOnAxis(To,t)}translateZ(t){return this.translateOnAxis(Ro,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Re.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Di.copy(t):Di.set(t,e,n);let i=this.parent;this.updateWorldMatrix(!0,!1),ti.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Re.lookAt(ti,Di,this.up):Re.lookAt(Di,ti,this.up),this.quaternion.setFromRotationMatrix(Re),i&&(Re.extractRotation(i.matrixWorld),yn.setFromRotationMatrix(Re),this.quaternion.premultiply(yn.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(vt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Co),Sn.child=t,this.dispatchEvent(Sn),Sn.child=null):vt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(wc),Ws.child=t,this.dispatchEvent(Ws),Ws.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Re.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Re.multiply(t.parent.matrixWorld)),t.applyMatrix4(Re),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Co),Sn.child=t,this.dispatchEvent(Sn),Sn.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,i=this.children.length;n<i;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let i=this.children;for(let s=0,o=i.length;s<o;s++)i[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ti,t,Mc),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ti,bc,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,i=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*i,s[13]+=n-s[1]*e-s[5]*n-s[9]*i,s[14]+=i-s[2]*e-s[6]*n-s[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(a=>({...a})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(t),i.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let f=c[l];s(t.shapes,f)}else s(t.shapes,c)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(t.materials,this.material[c]));i.material=a}else i.material=s(t.materials,this.material);if(this.children.length>0){i.children=[];for(let a=0;a<this.children.length;a++)i.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){i.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];i.animations.push(s(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),f=o(t.shapes),p=o(t.skeletons),m=o(t.animations),_=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),f.length>0&&(n.shapes=f),p.length>0&&(n.skeletons=p),m.length>0&&(n.animations=m),_.length>0&&(n.nodes=_)}return n.object=i,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let i=t.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ln.DEFAULT_UP=new $(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Vo={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ge={h:0,s:0,l:0},Ui={h:0,s:0,l:0};function Xs(r,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?r+(t-r)*6*e:e<1/2?t:e<2/3?r+(t-r)*6*(2/3-e):r}var Nt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let i=t;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ie){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ne.colorSpaceToWorking(this,e),this}setRGB(t,e,n,i=ne.workingColorSpace){return this.r=t,this.g=e,this.b=n,ne.colorSpaceToWorking(this,i),this}setHSL(t,e,n,i=ne.workingColorSpace){if(t=dc(t,1),e=ct(e,0,1),n=ct(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,o=2*n-s;this.r=Xs(o,s,t+1/3),this.g=Xs(o,s,t),this.b=Xs(o,s,t-1/3)}return ne.colorSpaceToWorking(this,i),this}setStyle(t,e=ie){function n(s){s!==void 0&&parseFloat(s)<1&&At("Color: Alpha component of "+t+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=i[1],a=i[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:At("Color: Unknown color model "+t)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=i[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(s,16),e);At("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ie){let n=Vo[t.toLowerCase()];return n!==void 0?this.setHex(n,e):At("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Le(t.r),this.g=Le(t.g),this.b=Le(t.b),this}copyLinearToSRGB(t){return this.r=Tn(t.r),this.g=Tn(t.g),this.b=Tn(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ie){return ne.workingToColorSpace(Ft.copy(this),t),Math.round(ct(Ft.r*255,0,255))*65536+Math.round(ct(Ft.g*255,0,255))*256+Math.round(ct(Ft.b*255,0,255))}getHexString(t=ie){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ne.workingColorSpace){ne.workingToColorSpace(Ft.copy(this),e);let n=Ft.r,i=Ft.g,s=Ft.b,o=Math.max(n,i,s),a=Math.min(n,i,s),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=u<=.5?f/(o+a):f/(2-o-a),o){case n:c=(i-s)/f+(i<s?6:0);break;case i:c=(s-n)/f+2;break;case s:c=(n-i)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,e=ne.workingColorSpace){return ne.workingToColorSpace(Ft.copy(this),e),t.r=Ft.r,t.g=Ft.g,t.b=Ft.b,t}getStyle(t=ie){ne.workingToColorSpace(Ft.copy(this),t);let e=Ft.r,n=Ft.g,i=Ft.b;return t!==ie?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(t,e,n){return this.getHSL(Ge),this.setHSL(Ge.h+t,Ge.s+e,Ge.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ge),t.getHSL(Ui);let n=zs(Ge.h,Ui.h,e),i=zs(Ge.s,Ui.s,e),s=zs(Ge.l,Ui.l,e);return this.setHSL(n,i,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,i=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*i,this.g=s[1]*e+s[4]*n+s[7]*i,this.b=s[2]*e+s[5]*n+s[8]*i,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ft=new Nt;Nt.NAMES=Vo;var Tt=class{constructor(t=new $(1/0,1/0,1/0),e=new $(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(le.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(le.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=le.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,le):le.fromBufferAttribute(s,o),le.applyMatrix4(t.matrixWorld),this.expandByPoint(le);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Oi.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Oi.copy(n.boundingBox)),Oi.applyMatrix4(t.matrixWorld),this.union(Oi)}let i=t.children;for(let s=0,o=i.length;s<o;s++)this.expandByObject(i[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,le),le.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ei),Fi.subVectors(this.max,ei),Mn.subVectors(t.a,ei),bn.subVectors(t.b,ei),wn.subVectors(t.c,ei),He.subVectors(bn,Mn),Ve.subVectors(wn,bn),nn.subVectors(Mn,wn);let e=[0,-He.z,He.y,0,-Ve.z,Ve.y,0,-nn.z,nn.y,He.z,0,-He.x,Ve.z,0,-Ve.x,nn.z,0,-nn.x,-He.y,He.x,0,-Ve.y,Ve.x,0,-nn.y,nn.x,0];return!$s(e,Mn,bn,wn,Fi)||(e=[1,0,0,0,1,0,0,0,1],!$s(e,Mn,bn,wn,Fi))?!1:(Bi.crossVectors(He,Ve),e=[Bi.x,Bi.y,Bi.z],$s(e,Mn,bn,wn,Fi))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,le).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(le).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ce[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ce[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ce[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ce[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ce[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ce[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ce[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ce[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ce),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ce=[new $,new $,new $,new $,new $,new $,new $,new $],le=new $,Oi=new Tt,Mn=new $,bn=new $,wn=new $,He=new $,Ve=new $,nn=new $,ei=new $,Fi=new $,Bi=new $,sn=new $;function $s(r,t,e,n,i){for(let s=0,o=r.length-3;s<=o;s+=3){sn.fromArray(r,s);let a=i.x*Math.abs(sn.x)+i.y*Math.abs(sn.y)+i.z*Math.abs(sn.z),c=t.dot(sn),l=e.dot(sn),u=n.dot(sn);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var Pe=Ec();function Ec(){let r=new ArrayBuffer(4),t=new Float32Array(r),e=new Uint32Array(r),n=new Uint32Array(512),i=new Uint32Array(512);for(let c=0;c<256;++c){let l=c-127;l<-27?(n[c]=0,n[c|256]=32768,i[c]=24,i[c|256]=24):l<-14?(n[c]=1024>>-l-14,n[c|256]=1024>>-l-14|32768,i[c]=-l-1,i[c|256]=-l-1):l<=15?(n[c]=l+15<<10,n[c|256]=l+15<<10|32768,i[c]=13,i[c|256]=13):l<128?(n[c]=31744,n[c|256]=64512,i[c]=24,i[c|256]=24):(n[c]=31744,n[c|256]=64512,i[c]=13,i[c|256]=13)}let s=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let c=1;c<1024;++c){let l=c<<13,u=0;for(;(l&8388608)===0;)l<<=1,u-=8388608;l&=-8388609,u+=947912704,s[c]=l|u}for(let c=1024;c<2048;++c)s[c]=939524096+(c-1024<<13);for(let c=1;c<31;++c)o[c]=c<<23;o[31]=1199570944,o[32]=2147483648;for(let c=33;c<63;++c)o[c]=2147483648+(c-32<<23);o[63]=3347054592;for(let c=1;c<64;++c)c!==32&&(a[c]=1024);return{floatView:t,uint32View:e,baseTable:n,shiftTable:i,mantissaTable:s,exponentTable:o,offsetTable:a}}function Ac(r){Math.abs(r)>65504&&At("DataUtils.toHalfFloat(): Value out of range."),r=ct(r,-65504,65504),Pe.floatView[0]=r;let t=Pe.uint32View[0],e=t>>23&511;return Pe.baseTable[e]+((t&8388607)>>Pe.shiftTable[e])}function Tc(r){let t=r>>10;return Pe.uint32View[0]=Pe.mantissaTable[Pe.offsetTable[t]+(r&1023)]+Pe.exponentTable[t],Pe.floatView[0]}var G=class{static toHalfFloat(t){return Ac(t)}static fromHalfFloat(t){return Tc(t)}},Et=new $,zi=new kt,Rc=0,he=class extends on{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Rc++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Go,this.updateRanges=[],this.gpuType=ue,this.version=0,this._normalizationScale=t!==void 0?Rr(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let i=0,s=this.itemSize;i<s;i++)this.array[t+i]=e.array[n+i];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)zi.fromBufferAttribute(this,e),zi.applyMatrix3(t),this.setXY(e,zi.x,zi.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Et.fromBufferAttribute(this,e),Et.applyMatrix3(t),this.setXYZ(e,Et.x,Et.y,Et.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Et.fromBufferAttribute(this,e),Et.applyMatrix4(t),this.setXYZ(e,Et.x,Et.y,Et.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Et.fromBufferAttribute(this,e),Et.applyNormalMatrix(t),this.setXYZ(e,Et.x,Et.y,Et.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Et.fromBufferAttribute(this,e),Et.transformDirection(t),this.setXYZ(e,Et.x,Et.y,Et.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this}setXYZW(t,e,n,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):pc(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):mc(t,this.array)}};var Zi=class extends he{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Ji=class extends he{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ki=class extends he{constructor(t,e,n){super(new Float32Array(t),e,n)}},Cc=new Tt,ni=new $,qs=new $,ji=class{constructor(t=new $,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Cc.setFromPoints(t).getCenter(n);let i=0;for(let s=0,o=t.length;s<o;s++)i=Math.max(i,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(i),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ni.subVectors(t,this.center);let e=ni.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),i=(n-this.radius)*.5;this.center.addScaledVector(ni,i/n),this.radius+=i}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(qs.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ni.copy(t.center).add(qs)),this.expandByPoint(ni.copy(t.center).sub(qs))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ic=0,ee=new se,Ys=new ln,En=new $,Zt=new Tt,ii=new Tt,Lt=new $,ai=class r extends on{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ic++}),this.uuid=cs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(cc(t)?Ji:Zi)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new ot().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(t),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ee.makeRotationFromQuaternion(t),this.applyMatrix4(ee),this}rotateX(t){return ee.makeRotationX(t),this.applyMatrix4(ee),this}rotateY(t){return ee.makeRotationY(t),this.applyMatrix4(ee),this}rotateZ(t){return ee.makeRotationZ(t),this.applyMatrix4(ee),this}translate(t,e,n){return ee.makeTranslation(t,e,n),this.applyMatrix4(ee),this}scale(t,e,n){return ee.makeScale(t,e,n),this.applyMatrix4(ee),this}lookAt(t){return Ys.lookAt(t),Ys.updateMatrix(),this.applyMatrix4(Ys.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(En).negate(),this.translate(En.x,En.y,En.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let i=0,s=t.length;i<s;i++){let o=t[i];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ki(n,3))}else{let n=Math.min(t.length,e.count);for(let i=0;i<n;i++){let s=t[i];e.setXYZ(i,s.x,s.y,s.z||0)}t.length>e.count&&At("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Tt);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){vt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new $(-1/0,-1/0,-1/0),new $(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,i=e.length;n<i;n++){let s=e[n];Zt.setFromBufferAttribute(s),this.morphTargetsRelative?(Lt.addVectors(this.boundingBox.min,Zt.min),this.boundingBox.expandByPoint(Lt),Lt.addVectors(this.boundingBox.max,Zt.max),this.boundingBox.expandByPoint(Lt)):(this.boundingBox.expandByPoint(Zt.min),this.boundingBox.expandByPoint(Zt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&vt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ji);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){vt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new $,1/0);return}if(t){let n=this.boundingSphere.center;if(Zt.setFromBufferAttribute(t),e)for(let s=0,o=e.length;s<o;s++){let a=e[s];ii.setFromBufferAttribute(a),this.morphTargetsRelative?(Lt.addVectors(Zt.min,ii.min),Zt.expandByPoint(Lt),Lt.addVectors(Zt.max,ii.max),Zt.expandByPoint(Lt)):(Zt.expandByPoint(ii.min),Zt.expandByPoint(ii.max))}Zt.getCenter(n);let i=0;for(let s=0,o=t.count;s<o;s++)Lt.fromBufferAttribute(t,s),i=Math.max(i,n.distanceToSquared(Lt));if(e)for(let s=0,o=e.length;s<o;s++){let a=e[s],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)Lt.fromBufferAttribute(a,l),c&&(En.fromBufferAttribute(t,l),Lt.add(En)),i=Math.max(i,n.distanceToSquared(Lt))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&vt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){vt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,i=e.normal,s=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new he(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let L=0;L<n.count;L++)a[L]=new $,c[L]=new $;let u=new $,f=new $,p=new $,m=new kt,_=new kt,v=new kt,b=new $,w=new $;function T(L,k,F){l[L]=l[k]=l[F]=1,u.fromBufferAttribute(n,L),f.fromBufferAttribute(n,k),p.fromBufferAttribute(n,F),m.fromBufferAttribute(s,L),_.fromBufferAttribute(s,k),v.fromBufferAttribute(s,F),f.sub(u),p.sub(u),_.sub(m),v.sub(m);let B=1/(_.x*v.y-v.x*_.y);isFinite(B)&&(b.copy(f).multiplyScalar(v.y).addScaledVector(p,-_.y).multiplyScalar(B),w.copy(p).multiplyScalar(_.x).addScaledVector(f,-v.x).multiplyScalar(B),a[L].add(b),a[k].add(b),a[F].add(b),c[L].add(w),c[k].add(w),c[F].add(w))}let N=this.groups;N.length===0&&(N=[{start:0,count:t.count}]);for(let L=0,k=N.length;L<k;++L){let F=N[L],B=F.start,et=F.count;for(let W=B,j=B+et;W<j;W+=3)T(t.getX(W+0),t.getX(W+1),t.getX(W+2))}let D=new $,U=new $,Y=new $,X=new $;function O(L){Y.fromBufferAttribute(i,L),X.copy(Y);let k=a[L];D.copy(k),D.sub(Y.multiplyScalar(Y.dot(k))).normalize(),U.crossVectors(X,k);let B=U.dot(c[L])<0?-1:1;o.setXYZW(L,D.x,D.y,D.z,B)}for(let L=0,k=n.count;L<k;++L)l[L]&&O(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new he(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let p=0,m=n.count;p<m;p++)n.setXYZ(p,0,0,0);let i=new $,s=new $,o=new $,a=new $,c=new $,l=new $,u=new $,f=new $;if(t)for(let p=0,m=t.count;p<m;p+=3){let _=t.getX(p+0),v=t.getX(p+1),b=t.getX(p+2);i.fromBufferAttribute(e,_),s.fromBufferAttribute(e,v),o.fromBufferAttribute(e,b),u.subVectors(o,s),f.subVectors(i,s),u.cross(f),a.fromBufferAttribute(n,_),c.fromBufferAttribute(n,v),l.fromBufferAttribute(n,b),a.add(u),c.add(u),l.add(u),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(v,c.x,c.y,c.z),n.setXYZ(b,l.x,l.y,l.z)}else for(let p=0,m=e.count;p<m;p+=3)i.fromBufferAttribute(e,p+0),s.fromBufferAttribute(e,p+1),o.fromBufferAttribute(e,p+2),u.subVectors(o,s),f.subVectors(i,s),u.cross(f),n.setXYZ(p+0,u.x,u.y,u.z),n.setXYZ(p+1,u.x,u.y,u.z),n.setXYZ(p+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Lt.fromBufferAttribute(t,e),Lt.normalize(),t.setXYZ(e,Lt.x,Lt.y,Lt.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,f=a.normalized,p=new l.constructor(c.length*u),m=0,_=0;for(let v=0,b=c.length;v<b;v++){a.isInterleavedBufferAttribute?m=c[v]*a.data.stride+a.offset:m=c[v]*u;for(let w=0;w<u;w++)p[_++]=l[m++]}return new he(p,u,f)}if(this.index===null)return At("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new r,n=this.index.array,i=this.attributes;for(let a in i){let c=i[a],l=t(c,n);e.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let u=0,f=l.length;u<f;u++){let p=l[u],m=t(p,n);c.push(m)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let i={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let f=0,p=l.length;f<p;f++){let m=l[f];u.push(m.toJSON(t.data))}u.length>0&&(i[c]=u,s=!0)}s&&(t.data.morphAttributes=i,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let i=t.attributes;for(let l in i){let u=i[l];this.setAttribute(l,u.clone(e))}let s=t.morphAttributes;for(let l in s){let u=[],f=s[l];for(let p=0,m=f.length;p<m;p++)u.push(f[p].clone(e));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var li=class extends an{constructor(t=null,e=1,n=1,i,s,o,a,c,l=rr,u=rr,f,p){super(null,o,a,c,l,u,i,s,f,p),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};function Wo(r){let t={};for(let e in r){t[e]={};for(let n in r[e]){let i=r[e][n];if(Io(i))i.isRenderTargetTexture?(At("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=i.clone();else if(Array.isArray(i))if(Io(i[0])){let s=[];for(let o=0,a=i.length;o<a;o++)s[o]=i[o].clone();t[e][n]=s}else t[e][n]=i.slice();else t[e][n]=i}}return t}function Gt(r){let t={};for(let e=0;e<r.length;e++){let n=Wo(r[e]);for(let i in n)t[i]=n[i]}return t}function Io(r){return r&&(r.isColor||r.isMatrix3||r.isMatrix4||r.isVector2||r.isVector3||r.isVector4||r.isTexture||r.isQuaternion)}function An(r,t){return!r||r.constructor===t?r:typeof t.BYTES_PER_ELEMENT=="number"?new t(r):Array.prototype.slice.call(r)}function ki(r){return r!==void 0&&r.inTangents!==void 0&&r.outTangents!==void 0}var We=class{constructor(t,e,n,i){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,i=e[n],s=e[n-1];n:{t:{let o;e:{i:if(!(t<i)){for(let a=n+2;;){if(i===void 0){if(t<s)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=i,i=e[++n],t<i)break t}o=e.length;break e}if(!(t>=s)){let a=e[1];t<a&&(n=2,s=a);for(let c=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(i=s,s=e[--n-1],t>=s)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(i=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,i)}return this.interpolate_(n,s,t,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,i=this.valueSize,s=t*i;for(let o=0;o!==i;++o)e[o]=n[s+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Qi=class extends We{constructor(t,e,n,i){super(t,e,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ar,endingEnd:ar}}intervalChanged_(t,e,n){let i=this.parameterPositions,s=t-2,o=t+1,a=i[s],c=i[o];if(a===void 0)switch(this.getSettings_().endingStart){case lr:s=t,a=2*e-n;break;case cr:s=i.length-2,a=e+i[s]-i[s+1];break;default:s=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case lr:o=t,c=2*n-e;break;case cr:o=1,c=n+i[1]-i[0];break;default:o=t-1,c=e}let l=(n-e)*.5,u=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,f=this._offsetNext,p=this._weightPrev,m=this._weightNext,_=(n-e)/(i-e),v=_*_,b=v*_,w=-p*b+2*p*v-p*_,T=(1+p)*b+(-1.5-2*p)*v+(-.5+p)*_+1,N=(-1-m)*b+(1.5+m)*v+.5*_,D=m*b-m*v;for(let U=0;U!==a;++U)s[U]=w*o[u+U]+T*o[l+U]+N*o[c+U]+D*o[f+U];return s}},ts=class extends We{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(n-e)/(i-e),f=1-u;for(let p=0;p!==a;++p)s[p]=o[l+p]*f+o[c+p]*u;return s}},es=class extends We{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t){return this.copySampleValue_(t-1)}},ns=class extends We{interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let _=(n-e)/(i-e),v=1-_;for(let b=0;b!==a;++b)s[b]=o[l+b]*v+o[c+b]*_;return s}let p=a*2,m=t-1;for(let _=0;_!==a;++_){let v=o[l+_],b=o[c+_],w=m*p+_*2,T=f[w],N=f[w+1],D=t*p+_*2,U=u[D],Y=u[D+1],X=Lc(n,e,T,U,i);s[_]=Xo(X,v,N,Y,b)}return s}};function Xo(r,t,e,n,i){let s=1-r;return s*s*s*t+3*s*s*r*e+3*s*r*r*n+r*r*r*i}function Pc(r,t,e,n,i){let s=1-r;return 3*s*s*(e-t)+6*s*r*(n-e)+3*r*r*(i-n)}function Lc(r,t,e,n,i){let s=(r-t)/(i-t);for(let o=0;o<8;o++){let a=Xo(s,t,e,n,i)-r;if(Math.abs(a)<1e-10)break;let c=Pc(s,t,e,n,i);if(Math.abs(c)<1e-10)break;s=Math.max(0,Math.min(1,s-a/c))}return s}var Kt=class{constructor(t,e,n,i){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=An(e,this.TimeBufferType),this.values=An(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:An(t.times,Array),values:An(t.values,Array)};let i=t.getInterpolation();i!==t.DefaultInterpolation&&(n.interpolation=i),ki(t.settings)&&(n.settings={inTangents:An(t.settings.inTangents,Array),outTangents:An(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new es(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new ts(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Qi(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new ns(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ri:e=this.InterpolantFactoryMethodDiscrete;break;case Wi:e=this.InterpolantFactoryMethodLinear;break;case Gi:e=this.InterpolantFactoryMethodSmooth;break;case or:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return At("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ri;case this.InterpolantFactoryMethodLinear:return Wi;case this.InterpolantFactoryMethodSmooth:return Gi;case this.InterpolantFactoryMethodBezier:return or}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]+=t;ki(this.settings)&&(Po(this.settings.inTangents,t),Po(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]*=t;ki(this.settings)&&(Lo(this.settings.inTangents,t),Lo(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,i=n.length,s=0,o=i-1;for(;s!==i&&n[s]<t;)++s;for(;o!==-1&&n[o]>e;)--o;if(++o,s!==0||o!==i){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(vt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,i=this.values,s=n.length;s===0&&(vt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){vt("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){vt("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(i!==void 0&&hc(i))for(let a=0,c=i.length;a!==c;++a){let l=i[a];if(isNaN(l)){vt("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===Gi,s=t.length-1,o=1;for(let a=1;a<s;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(i)c=!0;else{let f=a*n,p=f-n,m=f+n;for(let _=0;_!==n;++_){let v=e[f+_];if(v!==e[p+_]||v!==e[m+_]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let f=a*n,p=o*n;for(let m=0;m!==n;++m)e[p+m]=e[f+m]}++o}}if(s>0){t[o]=t[s];for(let a=s*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,i=new n(this.name,t,e);return i.createInterpolant=this.createInterpolant,ki(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function Po(r,t){for(let e=0,n=r.length;e!==n;e+=2)r[e]+=t}function Lo(r,t){for(let e=0,n=r.length;e!==n;e+=2)r[e]*=t}Kt.prototype.ValueTypeName="";Kt.prototype.TimeBufferType=Float32Array;Kt.prototype.ValueBufferType=Float32Array;Kt.prototype.DefaultInterpolation=Wi;var Xe=class extends Kt{constructor(t,e,n){super(t,e,n)}};Xe.prototype.ValueTypeName="bool";Xe.prototype.ValueBufferType=Array;Xe.prototype.DefaultInterpolation=ri;Xe.prototype.InterpolantFactoryMethodLinear=void 0;Xe.prototype.InterpolantFactoryMethodSmooth=void 0;var is=class extends Kt{constructor(t,e,n,i){super(t,e,n,i)}};is.prototype.ValueTypeName="color";var ss=class extends Kt{constructor(t,e,n,i){super(t,e,n,i)}};ss.prototype.ValueTypeName="number";var rs=class extends We{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(i-e),l=t*a;for(let u=l+a;l!==u;l+=4)Ne.slerpFlat(s,0,o,l-a,o,l,c);return s}},ci=class extends Kt{constructor(t,e,n,i){super(t,e,n,i)}InterpolantFactoryMethodLinear(t){return new rs(this.times,this.values,this.getValueSize(),t)}};ci.prototype.ValueTypeName="quaternion";ci.prototype.InterpolantFactoryMethodSmooth=void 0;var $e=class extends Kt{constructor(t,e,n){super(t,e,n)}};$e.prototype.ValueTypeName="string";$e.prototype.ValueBufferType=Array;$e.prototype.DefaultInterpolation=ri;$e.prototype.InterpolantFactoryMethodLinear=void 0;$e.prototype.InterpolantFactoryMethodSmooth=void 0;var os=class extends Kt{constructor(t,e,n,i){super(t,e,n,i)}};os.prototype.ValueTypeName="vector";var pr={enabled:!1,files:{},add:function(r,t){this.enabled!==!1&&(No(r)||(this.files[r]=t))},get:function(r){if(this.enabled!==!1&&!No(r))return this.files[r]},remove:function(r){delete this.files[r]},clear:function(){this.files={}}};function No(r){try{let t=r.slice(r.indexOf(":")+1);return new URL(t).protocol==="blob:"}catch{return!1}}var as=class{constructor(t,e,n){let i=this,s=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&i.onStart!==void 0&&i.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,i.onProgress!==void 0&&i.onProgress(u,o,a),o===a&&(s=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(u){i.onError!==void 0&&i.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,f){return l.push(u,f),this},this.removeHandler=function(u){let f=l.indexOf(u);return f!==-1&&l.splice(f,2),this},this.getHandler=function(u){for(let f=0,p=l.length;f<p;f+=2){let m=l[f],_=l[f+1];if(m.global&&(m.lastIndex=0),m.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},$o=new as,Rn=class{constructor(t){this.manager=t!==void 0?t:$o,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(i,s){n.load(t,i,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Rn.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ie={},mr=class extends Error{constructor(t,e){super(t),this.response=e}},ls=class extends Rn{constructor(t){super(t),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(t,e,n,i){t===void 0&&(t=""),this.path!==void 0&&(t=this.path+t),t=this.manager.resolveURL(t);let s=pr.get(`file:${t}`);if(s!==void 0){this.manager.itemStart(t),setTimeout(()=>{e&&e(s),this.manager.itemEnd(t)},0);return}if(Ie[t]!==void 0){Ie[t].push({onLoad:e,onProgress:n,onError:i});return}Ie[t]=[],Ie[t].push({onLoad:e,onProgress:n,onError:i});let o=new Request(t,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,c=this.responseType;fetch(o).then(l=>{if(l.status===200||l.status===0){if(l.status===0&&At("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||l.body===void 0||l.body.getReader===void 0)return l;let u=Ie[t],f=l.body.getReader(),p=l.headers.get("X-File-Size")||l.headers.get("Content-Length"),m=p?parseInt(p):0,_=m!==0,v=0,b=new ReadableStream({start(w){T();function T(){f.read().then(({done:N,value:D})=>{if(N)w.close();else{v+=D.byteLength;let U=new ProgressEvent("progress",{lengthComputable:_,loaded:v,total:m});for(let Y=0,X=u.length;Y<X;Y++){let O=u[Y];O.onProgress&&O.onProgress(U)}w.enqueue(D),T()}},N=>{w.error(N)})}}});return new Response(b)}else throw new mr(`fetch for "${l.url}" responded with ${l.status}: ${l.statusText}`,l)}).then(l=>{switch(c){case"arraybuffer":return l.arrayBuffer();case"blob":return l.blob();case"document":return l.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return l.json();default:if(a==="")return l.text();{let f=/charset="?([^;"\s]*)"?/i.exec(a),p=f&&f[1]?f[1].toLowerCase():void 0,m=new TextDecoder(p);return l.arrayBuffer().then(_=>m.decode(_))}}}).then(l=>{pr.add(`file:${t}`,l);let u=Ie[t];delete Ie[t];for(let f=0,p=u.length;f<p;f++){let m=u[f];m.onLoad&&m.onLoad(l)}}).catch(l=>{let u=Ie[t];if(u===void 0)throw this.manager.itemError(t),l;delete Ie[t];for(let f=0,p=u.length;f<p;f++){let m=u[f];m.onError&&m.onError(l)}this.manager.itemError(t)}).finally(()=>{this.manager.itemEnd(t)}),this.manager.itemStart(t)}setResponseType(t){return this.responseType=t,this}setMimeType(t){return this.mimeType=t,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var cn=class extends Rn{constructor(t){super(t)}load(t,e,n,i){let s=this,o=new li,a=new ls(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(s.withCredentials),a.load(t,function(c){let l;try{l=s.parse(c)}catch(u){i!==void 0?i(u):vt(u);return}s._applyTexData(o,l),e&&e(o,l)},n,i),o}createDataTexture(t){let e=new li;return this._applyTexData(e,this.parse(t)),e}_applyTexData(t,e){e.image!==void 0?t.image=e.image:e.data!==void 0&&(t.image.width=e.width,t.image.height=e.height,t.image.data=e.data),t.wrapS=e.wrapS!==void 0?e.wrapS:rn,t.wrapT=e.wrapT!==void 0?e.wrapT:rn,t.magFilter=e.magFilter!==void 0?e.magFilter:ce,t.minFilter=e.minFilter!==void 0?e.minFilter:ce,t.anisotropy=e.anisotropy!==void 0?e.anisotropy:1,e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.mipmaps!==void 0&&(t.mipmaps=e.mipmaps,t.minFilter=Ar),e.mipmapCount===1&&(t.minFilter=ce),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),t.needsUpdate=!0}};var Cr="\\[\\]\\.:\\/",Nc=new RegExp("["+Cr+"]","g"),Ir="[^"+Cr+"]",Dc="[^"+Cr.replace("\\.","")+"]",Uc=/((?:WC+[\/:])*)/.source.replace("WC",Ir),Oc=/(WCOD+)?/.source.replace("WCOD",Dc),Fc=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ir),Bc=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ir),zc=new RegExp("^"+Uc+Oc+Fc+Bc+"$"),kc=["material","materials","bones","map"],gr=class{constructor(t,e,n){let i=n||xt.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,i)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,s=n.length;i!==s;++i)n[i].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},xt=class r{constructor(t,e,n){this.path=e,this.parsedPath=n||r.parseTrackName(e),this.node=r.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new r.Composite(t,e,n):new r(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Nc,"")}static parseTrackName(t){let e=zc.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let s=n.nodeName.substring(i+1);kc.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},i=n(t.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)t[e++]=n[i]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,i=e.propertyName,s=e.propertyIndex;if(t||(t=r.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){At("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){vt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){vt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){vt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){vt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){vt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){vt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){vt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[i];if(o===void 0){let l=e.nodeName;vt("PropertyBinding: Trying to update property for track: "+l+"."+i+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(i==="morphTargetInfluences"){if(!t.geometry){vt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){vt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};xt.Composite=gr;xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};xt.prototype.GetterByBindingType=[xt.prototype._getValue_direct,xt.prototype._getValue_array,xt.prototype._getValue_arrayElement,xt.prototype._getValue_toArray];xt.prototype.SetterByBindingTypeAndVersioning=[[xt.prototype._setValue_direct,xt.prototype._setValue_direct_setNeedsUpdate,xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[xt.prototype._setValue_array,xt.prototype._setValue_array_setNeedsUpdate,xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[xt.prototype._setValue_arrayElement,xt.prototype._setValue_arrayElement_setNeedsUpdate,xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[xt.prototype._setValue_fromArray,xt.prototype._setValue_fromArray_setNeedsUpdate,xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var em=new Float32Array(1);var _r=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,i){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,i){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=i,this}};typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?At("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");var Gc=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Hc=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Vc=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Wc=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Xc=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,$c=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,qc=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Yc=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Zc=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Jc=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Kc=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,jc=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Qc=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,th=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,eh=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,nh=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,ih=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,sh=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,rh=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,oh=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ah=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,lh=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ch=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,hh=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,uh=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,fh=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,dh=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ph=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,mh=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,gh="gl_FragColor = linearToOutputTexel( gl_FragColor );",_h=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,xh=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,vh=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,yh=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Sh=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Mh=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,bh=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,wh=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Eh=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ah=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Th=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Rh=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ch=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ih=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ph=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Lh=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Nh=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Dh=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Uh=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Oh=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Fh=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Bh=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,zh=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,kh=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Gh=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Hh=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Vh=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Wh=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Xh=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$h=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,qh=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Yh=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Zh=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Jh=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Kh=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,jh=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Qh=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,tu=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,eu=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nu=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,iu=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,su=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ru=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,ou=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,au=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lu=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,cu=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,hu=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,uu=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,fu=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,du=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,pu=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,mu=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,gu=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,_u=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,xu=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,vu=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,yu=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Su=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Mu=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,bu=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,wu=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Eu=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Au=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Tu=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ru=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Cu=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Iu=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Pu=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Lu=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Nu=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Du=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Uu=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Ou=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Fu=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Bu=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,zu=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ku=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Gu=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Hu=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Vu=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Wu=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Xu=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$u=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,qu=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Yu=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Zu=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Ju=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ku=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ju=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Qu=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,tf=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,ef=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nf=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sf=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rf=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,of=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,af=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,lf=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,cf=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hf=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uf=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,ff=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,df=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pf=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mf=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,gf=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,_f=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,xf=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vf=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,yf=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:Gc,alphahash_pars_fragment:Hc,alphamap_fragment:Vc,alphamap_pars_fragment:Wc,alphatest_fragment:Xc,alphatest_pars_fragment:$c,aomap_fragment:qc,aomap_pars_fragment:Yc,batching_pars_vertex:Zc,batching_vertex:Jc,begin_vertex:Kc,beginnormal_vertex:jc,bsdfs:Qc,iridescence_fragment:th,bumpmap_pars_fragment:eh,clipping_planes_fragment:nh,clipping_planes_pars_fragment:ih,clipping_planes_pars_vertex:sh,clipping_planes_vertex:rh,color_fragment:oh,color_pars_fragment:ah,color_pars_vertex:lh,color_vertex:ch,common:hh,defaultnormal_vertex:uh,displacementmap_pars_vertex:fh,displacementmap_vertex:dh,emissivemap_fragment:ph,emissivemap_pars_fragment:mh,colorspace_fragment:gh,colorspace_pars_fragment:_h,envmap_fragment:xh,envmap_common_pars_fragment:vh,envmap_pars_fragment:yh,envmap_pars_vertex:Sh,envmap_physical_pars_fragment:Lh,envmap_vertex:Mh,fog_vertex:bh,fog_pars_vertex:wh,fog_fragment:Eh,fog_pars_fragment:Ah,gradientmap_pars_fragment:Th,lightmap_pars_fragment:Rh,lights_lambert_fragment:Ch,lights_lambert_pars_fragment:Ih,lights_pars_begin:Ph,lights_toon_fragment:Nh,lights_toon_pars_fragment:Dh,lights_phong_fragment:Uh,lights_phong_pars_fragment:Oh,lights_physical_fragment:Fh,lights_physical_pars_fragment:Bh,lights_fragment_begin:zh,lights_fragment_maps:kh,lights_fragment_end:Gh,lightprobes_pars_fragment:Hh,logdepthbuf_fragment:Vh,logdepthbuf_pars_fragment:Wh,logdepthbuf_pars_vertex:Xh,logdepthbuf_vertex:$h,map_fragment:qh,map_pars_fragment:Yh,map_particle_fragment:Zh,map_particle_pars_fragment:Jh,metalnessmap_fragment:Kh,metalnessmap_pars_fragment:jh,morphinstance_vertex:Qh,morphcolor_vertex:tu,morphnormal_vertex:eu,morphtarget_pars_vertex:nu,morphtarget_vertex:iu,normal_fragment_begin:su,normal_fragment_maps:ru,normal_pars_fragment:ou,normal_pars_vertex:au,normal_vertex:lu,normalmap_pars_fragment:cu,clearcoat_normal_fragment_begin:hu,clearcoat_normal_fragment_maps:uu,clearcoat_pars_fragment:fu,iridescence_pars_fragment:du,opaque_fragment:pu,packing:mu,premultiplied_alpha_fragment:gu,project_vertex:_u,dithering_fragment:xu,dithering_pars_fragment:vu,roughnessmap_fragment:yu,roughnessmap_pars_fragment:Su,shadowmap_pars_fragment:Mu,shadowmap_pars_vertex:bu,shadowmap_vertex:wu,shadowmask_pars_fragment:Eu,skinbase_vertex:Au,skinning_pars_vertex:Tu,skinning_vertex:Ru,skinnormal_vertex:Cu,specularmap_fragment:Iu,specularmap_pars_fragment:Pu,tonemapping_fragment:Lu,tonemapping_pars_fragment:Nu,transmission_fragment:Du,transmission_pars_fragment:Uu,uv_pars_fragment:Ou,uv_pars_vertex:Fu,uv_vertex:Bu,worldpos_vertex:zu,background_vert:ku,background_frag:Gu,backgroundCube_vert:Hu,backgroundCube_frag:Vu,cube_vert:Wu,cube_frag:Xu,depth_vert:$u,depth_frag:qu,distance_vert:Yu,distance_frag:Zu,equirect_vert:Ju,equirect_frag:Ku,linedashed_vert:ju,linedashed_frag:Qu,meshbasic_vert:tf,meshbasic_frag:ef,meshlambert_vert:nf,meshlambert_frag:sf,meshmatcap_vert:rf,meshmatcap_frag:of,meshnormal_vert:af,meshnormal_frag:lf,meshphong_vert:cf,meshphong_frag:hf,meshphysical_vert:uf,meshphysical_frag:ff,meshtoon_vert:df,meshtoon_frag:pf,points_vert:mf,points_frag:gf,shadow_vert:_f,shadow_frag:xf,sprite_vert:vf,sprite_frag:yf},Z={common:{diffuse:{value:new Nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new Nt(16777215)},opacity:{value:1},center:{value:new kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},qo={basic:{uniforms:Gt([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Gt([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,Z.lights,{emissive:{value:new Nt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Gt([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,Z.lights,{emissive:{value:new Nt(0)},specular:{value:new Nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Gt([Z.common,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.roughnessmap,Z.metalnessmap,Z.fog,Z.lights,{emissive:{value:new Nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Gt([Z.common,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.gradientmap,Z.fog,Z.lights,{emissive:{value:new Nt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Gt([Z.common,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Gt([Z.points,Z.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Gt([Z.common,Z.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Gt([Z.common,Z.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Gt([Z.common,Z.bumpmap,Z.normalmap,Z.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Gt([Z.sprite,Z.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Gt([Z.common,Z.displacementmap,{referencePosition:{value:new $},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Gt([Z.lights,Z.fog,{color:{value:new Nt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};qo.physical={uniforms:Gt([qo.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new Nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new Nt(0)},specularColor:{value:new Nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Sf=new ot;Sf.set(-1,0,0,0,1,0,0,0,1);var by={[xr]:"LINEAR_TONE_MAPPING",[vr]:"REINHARD_TONE_MAPPING",[yr]:"CINEON_TONE_MAPPING",[Sr]:"ACES_FILMIC_TONE_MAPPING",[br]:"AGX_TONE_MAPPING",[wr]:"NEUTRAL_TONE_MAPPING",[Mr]:"CUSTOM_TONE_MAPPING"};var wy=new Float32Array(16),Ey=new Float32Array(9),Ay=new Float32Array(4);var Ty={[xr]:"Linear",[vr]:"Reinhard",[yr]:"Cineon",[Sr]:"ACESFilmic",[br]:"AgX",[wr]:"Neutral",[Mr]:"Custom"};var Ry={[Do]:"SHADOWMAP_TYPE_PCF",[Uo]:"SHADOWMAP_TYPE_VSM"};var Cy={[zo]:"ENVMAP_MODE_REFRACTION"};var Iy={[Oo]:"ENVMAP_BLENDING_MULTIPLY",[Fo]:"ENVMAP_BLENDING_MIX",[Bo]:"ENVMAP_BLENDING_ADD"};var Mf=new ot;Mf.set(-1,0,0,0,1,0,0,0,1);var Py=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);var hs=Math.pow(2,-24),Pr=Symbol("SKIP_GENERATION"),us={strategy:0,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[Pr]:!1};function Ct(r,t,e){return e.min.x=t[r],e.min.y=t[r+1],e.min.z=t[r+2],e.max.x=t[r+3],e.max.y=t[r+4],e.max.z=t[r+5],e}function hi(r){let t=-1,e=-1/0;for(let n=0;n<3;n++){let i=r[n+3]-r[n];i>e&&(e=i,t=n)}return t}function Lr(r,t,e){for(let n=0;n<3;n++){let i=t[r+2*n],s=t[r+2*n+1],o=i-s,a=i+s;o<e[n]&&(e[n]=o),a>e[n+3]&&(e[n+3]=a)}}function fs(r){let t=r[3]-r[0],e=r[4]-r[1],n=r[5]-r[2];return 2*(t*e+e*n+n*t)}function Bt(r,t){return t[r+15]===65535}function Xt(r,t){return t[r+6]}function re(r,t){return t[r+14]}function jt(r){return r+8}function Qt(r,t){let e=t[r+6];return r+e*8}function Yo(r,t){return t[r+7]}function ds(r,t,e,n,i){let s=1/0,o=1/0,a=1/0,c=-1/0,l=-1/0,u=-1/0,f=1/0,p=1/0,m=1/0,_=-1/0,v=-1/0,b=-1/0,w=r.offset||0;for(let T=(t-w)*6,N=(t+e-w)*6;T<N;T+=6){let D=r[T+0],U=r[T+1],Y=D-U,X=D+U;Y<s&&(s=Y),X>c&&(c=X),D<f&&(f=D),D>_&&(_=D);let O=r[T+2],L=r[T+3],k=O-L,F=O+L;k<o&&(o=k),F>l&&(l=F),O<p&&(p=O),O>v&&(v=O);let B=r[T+4],et=r[T+5],W=B-et,j=B+et;W<a&&(a=W),j>u&&(u=j),B<m&&(m=B),B>b&&(b=B)}n[0]=s,n[1]=o,n[2]=a,n[3]=c,n[4]=l,n[5]=u,i[0]=f,i[1]=p,i[2]=m,i[3]=_,i[4]=v,i[5]=b}var Me=8,Dr=8,Nr=new Int32Array(Me),Se=new Float32Array(Me*6),In=new Float32Array(Me*6),de=new Float32Array(6),ps=new Float32Array(6),qe=new Int32Array(Dr),Jo=new Float32Array(Dr*6);function Ef(r,t,e,n){for(let i=0;i<3;i++){let s=t[r+2*i],o=t[r+2*i+1],a=s-o,c=s+o;a<e[n+i]&&(e[n+i]=a),c>e[n+i+3]&&(e[n+i+3]=c)}}function Ko(r,t){let e=r[t+3]-r[t],n=r[t+4]-r[t+1],i=r[t+5]-r[t+2];return 2*(e*n+n*i+i*e)}function ta(r,t,e,n,i,s){let o=-1,a=0;if(s===0)o=hi(t),o!==-1&&(a=(t[o]+t[o+3])/2);else if(s===1)o=hi(r),o!==-1&&(a=Af(e,n,i,o));else if(s===2){let c=fs(r),l=1.25*i,u=e.offset||0,f=(n-u)*6,p=(n+i-u)*6;for(let m=0;m<3;m++){let _=t[m],w=(t[m+3]-_)/Me;if(i<Dr){for(let T=0;T<i;T++){let N=f+T*6,D=e[N+2*m],U=T;for(;U>0&&e[qe[U-1]+2*m]>D;)qe[U]=qe[U-1],U--;qe[U]=N}for(let T=0;T<3;T++)de[T]=1/0,de[T+3]=-1/0,ps[T]=1/0,ps[T+3]=-1/0;for(let T=i-1;T>=0;T--)Lr(qe[T],e,ps),Jo.set(ps,T*6);for(let T=0;T<i-1;T++){Lr(qe[T],e,de);let N=e[qe[T+1]+2*m];if(e[qe[T]+2*m]===N)continue;let D=T+1,U=i-D,Y=fs(de)/c,X=Ko(Jo,D*6)/c,O=1+1.25*(Y*D+X*U);O<l&&(o=m,l=O,a=N)}}else{for(let D=0;D<Me;D++){Nr[D]=0;for(let U=0;U<3;U++)Se[D*6+U]=1/0,Se[D*6+U+3]=-1/0}for(let D=f;D<p;D+=6){let X=~~((e[D+2*m]-_)/w);X>=Me&&(X=Me-1),Nr[X]++,Ef(D,e,Se,X*6)}let T=(Me-1)*6;for(let D=0;D<6;D++)In[T+D]=Se[T+D];for(let D=Me-2;D>=0;D--){let U=D*6,Y=U+6;for(let X=0;X<3;X++)In[U+X]=Math.min(Se[U+X],In[Y+X]),In[U+X+3]=Math.max(Se[U+X+3],In[Y+X+3])}let N=0;for(let D=0;D<Me-1;D++){let U=D*6,Y=Nr[D];if(Y!==0)for(let F=0;F<3;F++)N===0?(de[F]=Se[U+F],de[F+3]=Se[U+F+3]):(de[F]=Math.min(de[F],Se[U+F]),de[F+3]=Math.max(de[F+3],Se[U+F+3]));N+=Y;let X=0,O=0;N!==0&&(X=fs(de)/c);let L=i-N;L!==0&&(O=Ko(In,U+6)/c);let k=1+1.25*(X*N+O*L);k<l&&(o=m,l=k,a=_+w+D*w)}}}}else console.warn(`BVH: Invalid build strategy value ${s} used.`);return{axis:o,pos:a}}function Af(r,t,e,n){let i=0,s=r.offset;for(let o=t,a=t+e;o<a;o++)i+=r[(o-s)*6+n*2];return i/e}function ea(r,t,e,n,i,s){let o=n,a=n+i-1,c=s.pos,l=s.axis*2,u=e.offset||0;for(;;){for(;o<=a&&e[(o-u)*6+l]<c;)o++;for(;o<=a&&e[(a-u)*6+l]>=c;)a--;if(o<a){for(let f=0;f<t;f++){let p=r[o*t+f];r[o*t+f]=r[a*t+f],r[a*t+f]=p}for(let f=0;f<6;f++){let p=o-u,m=a-u,_=e[p*6+f];e[p*6+f]=e[m*6+f],e[m*6+f]=_}o++,a--}else return o}}var Tf=Math.pow(2,32),Pn=new Float32Array(6),ms=new Float32Array(6);function Rf(r,t,e,n,i,s){let{maxDepth:o,verbose:a,targetLeafSize:c,_strictLeafSize:l=1/0,strategy:u,onProgress:f,useSharedArrayBuffer:p=!1}=i,m=r.primitiveBuffer,_=r.primitiveBufferStride,v=p?SharedArrayBuffer:ArrayBuffer,b=new v(32*Math.max(1,2*Math.ceil(n)-1)),w=new Float32Array(b),T=new Uint32Array(b),N=new Uint16Array(b),D=0,U=!1;return ds(t,e,n,Pn,ms),O(e,n,0),b.slice(0,D*32);function Y(L){f&&f((L-s.offset)/s.count)}function X(L,k,F){let B=L*2;T[L+6]=k,N[B+14]=F,N[B+15]=65535,Y(k+F)}function O(L,k,F){let B=D++,et=B*8;w.set(Pn,et),!U&&F>=o&&(U=!0,a&&console.warn(`BVH: Max depth of ${o} reached when generating BVH. Consider increasing maxDepth.`));let W=k>l;if(k<=c&&!W||F>=o){X(et,L,k);return}let j=ta(Pn,ms,t,L,k,u),it=j.axis===-1?-1:ea(m,_,t,L,k,j);if(j.axis===-1||it===L||it===L+k){if(!W){X(et,L,k);return}j.axis=Math.max(0,hi(Pn)),it=L+Math.max(1,Math.floor(k/2))}T[et+7]=j.axis;let St=it-L;ds(t,L,St,Pn,ms),O(L,St,F+1);let zt=D-B;if(zt>Tf)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");T[et+6]=zt;let _t=k-St;ds(t,it,_t,Pn,ms),O(it,_t,F+1)}}function na(r,t){let e=r.getRootRanges(t.range),n=e[0],i=e[e.length-1],s={offset:n.offset,count:i.offset+i.count-n.offset},o=new Float32Array(6*s.count);o.offset=s.offset,r.computePrimitiveBounds(s.offset,s.count,o),r._roots=e.map(a=>Rf(r,o,a.offset,a.count,t,s))}var Ln=class{constructor(t){this._getNewPrimitive=t,this._primitives=[]}getPrimitive(){let t=this._primitives;return t.length===0?this._getNewPrimitive():t.pop()}releasePrimitive(t){this._primitives.push(t)}};var Ur=class{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;let t=[],e=null;this.setBuffer=n=>{e&&t.push(e),e=n,this.float32Array=new Float32Array(n),this.uint16Array=new Uint16Array(n),this.uint32Array=new Uint32Array(n)},this.clearBuffer=()=>{e=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,t.length!==0&&this.setBuffer(t.pop())}}},De=new Ur;var Ye,Dn,Nn=[],gs=new Ln(()=>new Tt);function ia(r,t,e,n,i,s){Ye=gs.getPrimitive(),Dn=gs.getPrimitive(),Nn.push(Ye,Dn),De.setBuffer(r._roots[t]);let o=Or(0,r.geometry,e,n,i,s);De.clearBuffer(),gs.releasePrimitive(Ye),gs.releasePrimitive(Dn),Nn.pop(),Nn.pop();let a=Nn.length;return a>0&&(Dn=Nn[a-1],Ye=Nn[a-2]),o}function Or(r,t,e,n,i=null,s=0,o=0){let{float32Array:a,uint16Array:c,uint32Array:l}=De,u=r*2;if(Bt(u,c)){let p=Xt(r,l),m=re(u,c);return Ct(r,a,Ye),n(p,m,!1,o,s+r/8,Ye)}else{let k=function(B){let{uint16Array:et,uint32Array:W}=De,j=B*2;for(;!Bt(j,et);)B=jt(B),j=B*2;return Xt(B,W)},F=function(B){let{uint16Array:et,uint32Array:W}=De,j=B*2;for(;!Bt(j,et);)B=Qt(B,W),j=B*2;return Xt(B,W)+re(j,et)},p=jt(r),m=Qt(r,l),_=p,v=m,b,w,T,N;if(i&&(T=Ye,N=Dn,Ct(_,a,T),Ct(v,a,N),b=i(T),w=i(N),w<b)){_=m,v=p;let B=b;b=w,w=B,T=N}T||(T=Ye,Ct(_,a,T));let D=Bt(_*2,c),U=e(T,D,b,o+1,s+_/8),Y;if(U===2){let B=k(_),W=F(_)-B;Y=n(B,W,!0,o+1,s+_/8,T)}else Y=U&&Or(_,t,e,n,i,s,o+1);if(Y)return!0;N=Dn,Ct(v,a,N);let X=Bt(v*2,c),O=e(N,X,w,o+1,s+v/8),L;if(O===2){let B=k(v),W=F(v)-B;L=n(B,W,!0,o+1,s+v/8,N)}else L=O&&Or(v,t,e,n,i,s,o+1);return!!L}}var ui=new De.constructor,_s=new De.constructor,Ze=new Ln(()=>new Tt),Un=new Tt,On=new Tt,Fr=new Tt,Br=new Tt,zr=!1;function sa(r,t,e,n){if(zr)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");zr=!0;let i=r._roots,s=t._roots,o,a=0,c=0,l=new se().copy(e).invert();for(let u=0,f=i.length;u<f;u++){ui.setBuffer(i[u]),c=0;let p=Ze.getPrimitive();Ct(0,ui.float32Array,p),p.applyMatrix4(l);for(let m=0,_=s.length;m<_&&(_s.setBuffer(s[m]),o=pe(0,0,e,l,n,a,c,0,0,p),_s.clearBuffer(),c+=s[m].byteLength/32,!o);m++);if(Ze.releasePrimitive(p),ui.clearBuffer(),a+=i[u].byteLength/32,o)break}return zr=!1,o}function pe(r,t,e,n,i,s=0,o=0,a=0,c=0,l=null,u=!1){let f,p;u?(f=_s,p=ui):(f=ui,p=_s);let m=f.float32Array,_=f.uint32Array,v=f.uint16Array,b=p.float32Array,w=p.uint32Array,T=p.uint16Array,N=r*2,D=t*2,U=Bt(N,v),Y=Bt(D,T),X=!1;if(Y&&U)u?X=i(Xt(t,w),re(t*2,T),Xt(r,_),re(r*2,v),c,o+t/8,a,s+r/8):X=i(Xt(r,_),re(r*2,v),Xt(t,w),re(t*2,T),a,s+r/8,c,o+t/8);else if(Y){let O=Ze.getPrimitive();Ct(t,b,O),O.applyMatrix4(e);let L=jt(r),k=Qt(r,_);Ct(L,m,Un),Ct(k,m,On);let F=O.intersectsBox(Un),B=O.intersectsBox(On);X=F&&pe(t,L,n,e,i,o,s,c,a+1,O,!u)||B&&pe(t,k,n,e,i,o,s,c,a+1,O,!u),Ze.releasePrimitive(O)}else{let O=jt(t),L=Qt(t,w);Ct(O,b,Fr),Ct(L,b,Br);let k=l.intersectsBox(Fr),F=l.intersectsBox(Br);if(k&&F)X=pe(r,O,e,n,i,s,o,a,c+1,l,u)||pe(r,L,e,n,i,s,o,a,c+1,l,u);else if(k)if(U)X=pe(r,O,e,n,i,s,o,a,c+1,l,u);else{let B=Ze.getPrimitive();B.copy(Fr).applyMatrix4(e);let et=jt(r),W=Qt(r,_);Ct(et,m,Un),Ct(W,m,On);let j=B.intersectsBox(Un),it=B.intersectsBox(On);X=j&&pe(O,et,n,e,i,o,s,c,a+1,B,!u)||it&&pe(O,W,n,e,i,o,s,c,a+1,B,!u),Ze.releasePrimitive(B)}else if(F)if(U)X=pe(r,L,e,n,i,s,o,a,c+1,l,u);else{let B=Ze.getPrimitive();B.copy(Br).applyMatrix4(e);let et=jt(r),W=Qt(r,_);Ct(et,m,Un),Ct(W,m,On);let j=B.intersectsBox(Un),it=B.intersectsBox(On);X=j&&pe(L,et,n,e,i,o,s,c,a+1,B,!u)||it&&pe(L,W,n,e,i,o,s,c,a+1,B,!u),Ze.releasePrimitive(B)}}return X}var xs=new class{constructor(){let r=null,t=null,e=null,n=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(s,o)=>{if(n)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=o,this.buffer=r=s._roots[o],this.uint16Array=e=new Uint16Array(r),this.uint32Array=t=new Uint32Array(r)},this.reset=()=>{this.root=null,this.buffer=r=null,this.uint16Array=e=null,this.uint32Array=t=null},this.getRangeStart=s=>{let o=s*2;for(;!Bt(o,e);)s=jt(s),o=s*2;return Xt(s,t)},this.getRangeEnd=s=>{let o=s*2;for(;!Bt(o,e);)s=Qt(s,t),o=s*2;return Xt(s,t)+re(o,e)};let i=(s,o,a)=>{let c=o*2,l=Bt(c,e);if(!s(a,l,o)&&!l){let f=jt(o),p=Qt(o,t);i(s,f,a+1),i(s,p,a+1)}};this.traverseBuffer=s=>{if(n)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");n=!0;try{i(s,0,0)}finally{n=!1}},this.traverse=s=>{this.traverseBuffer((o,a,c)=>{if(a){let l=c*2,u=t[c+6],f=e[l+14];return s(o,a,new Float32Array(r,c*4,6),u,f)}else{let l=Yo(c,t);return s(o,a,new Float32Array(r,c*4,6),l)}})}}};var ra=new Tt,Fn=new Float32Array(6),vs=class{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(t){t={...us,...t},"maxLeafSize"in t&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafSize}),na(this,t)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(t,e,n,i){let s=1/0,o=1/0,a=1/0,c=-1/0,l=-1/0,u=-1/0;for(let f=t,p=t+e;f<p;f++){this.writePrimitiveBounds(f,Fn,0);let[m,_,v,b,w,T]=Fn;m<s&&(s=m),b>c&&(c=b),_<o&&(o=_),w>l&&(l=w),v<a&&(a=v),T>u&&(u=T)}return n[i+0]=s,n[i+1]=o,n[i+2]=a,n[i+3]=c,n[i+4]=l,n[i+5]=u,n}computePrimitiveBounds(t,e,n){let i=n.offset||0;for(let s=t,o=t+e;s<o;s++){this.writePrimitiveBounds(s,Fn,0);let[a,c,l,u,f,p]=Fn,m=(a+u)/2,_=(c+f)/2,v=(l+p)/2,b=(u-a)/2,w=(f-c)/2,T=(p-l)/2,N=(s-i)*6;n[N+0]=m,n[N+1]=b+(Math.abs(m)+b)*hs,n[N+2]=_,n[N+3]=w+(Math.abs(_)+w)*hs,n[N+4]=v,n[N+5]=T+(Math.abs(v)+T)*hs}return n}shiftPrimitiveOffsets(t){let e=this._indirectBuffer;if(e)for(let n=0,i=e.length;n<i;n++)e[n]+=t;else{let n=this._roots;for(let i=0;i<n.length;i++){let s=n[i],o=new Uint32Array(s),a=new Uint16Array(s),c=s.byteLength/32;for(let l=0;l<c;l++){let u=8*l,f=2*u;Bt(f,a)&&(o[u+6]+=t)}}}}traverse(t,e=0){xs.setBVH(this,e),xs.traverse(t),xs.reset()}refit(){let t=this._roots;for(let e=0,n=t.length;e<n;e++){let i=t[e],s=new Uint32Array(i),o=new Uint16Array(i),a=new Float32Array(i),c=i.byteLength/32;for(let l=c-1;l>=0;l--){let u=l*8,f=u*2;if(Bt(f,o)){let m=Xt(u,s),_=re(f,o);this.writePrimitiveRangeBounds(m,_,Fn,0),a.set(Fn,u)}else{let m=jt(u),_=Qt(u,s);for(let v=0;v<3;v++){let b=a[m+v],w=a[m+v+3],T=a[_+v],N=a[_+v+3];a[u+v]=b<T?b:T,a[u+v+3]=w>N?w:N}}}}}getBoundingBox(t){return t.makeEmpty(),this._roots.forEach(n=>{Ct(0,new Float32Array(n),ra),t.union(ra)}),t}shapecast(t){let{boundsTraverseOrder:e,intersectsBounds:n,intersectsRange:i,intersectsPrimitive:s,scratchPrimitive:o,iterate:a}=t;if(i&&s){let f=i;i=(p,m,_,v,b)=>f(p,m,_,v,b)?!0:a(p,m,this,s,_,v,o)}else i||(s?i=(f,p,m,_)=>a(f,p,this,s,m,_,o):i=(f,p,m)=>m);let c=!1,l=0,u=this._roots;for(let f=0,p=u.length;f<p;f++){let m=u[f];if(c=ia(this,f,n,i,e,l),c)break;l+=m.byteLength/32}return c}bvhcast(t,e,n){let{intersectsRanges:i}=n;return sa(this,t,e,i)}};function oa(){return typeof SharedArrayBuffer<"u"}function aa(r){return r.index?r.index.count:r.attributes.position.count}function Pf(r,t=ArrayBuffer){return r>65535?new Uint32Array(new t(4*r)):new Uint16Array(new t(2*r))}function la(r,t){if(!r.index){let e=r.attributes.position.count,n=t.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,i=Pf(e,n);r.setIndex(new he(i,1));for(let s=0;s<e;s++)i[s]=s}}function Lf(r,t,e){let n=aa(r)/e,i=t||r.drawRange,s=i.start/e,o=(i.start+i.count)/e,a=Math.max(0,s),c=Math.min(n,o)-a;return{offset:Math.floor(a),count:Math.floor(c)}}function Nf(r,t){return r.groups.map(e=>({offset:e.start/t,count:e.count/t}))}function kr(r,t,e){let n=Lf(r,t,e),i=Nf(r,e);if(!i.length)return[n];let s=[],o=n.offset,a=n.offset+n.count,c=aa(r)/e,l=[];for(let p of i){let{offset:m,count:_}=p,v=m,b=isFinite(_)?_:c-m,w=m+b;v<a&&w>o&&(l.push({pos:Math.max(o,v),isStart:!0}),l.push({pos:Math.min(a,w),isStart:!1}))}l.sort((p,m)=>p.pos!==m.pos?p.pos-m.pos:p.type==="end"?-1:1);let u=0,f=null;for(let p of l){let m=p.pos;u!==0&&m!==f&&s.push({offset:f,count:m-f}),u+=p.isStart?1:-1,f=m}return s}function Df(r,t){let e=r[r.length-1],n=e.offset+e.count>2**16,i=r.reduce((l,u)=>l+u.count,0),s=n?4:2,o=t?new SharedArrayBuffer(i*s):new ArrayBuffer(i*s),a=n?new Uint32Array(o):new Uint16Array(o),c=0;for(let l=0;l<r.length;l++){let{offset:u,count:f}=r[l];for(let p=0;p<f;p++)a[c+p]=u+p;c+=f}return a}var ys=class extends vs{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(t){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(t){}constructor(t,e={}){if(t.isBufferGeometry){if(t.index&&t.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(e.useSharedArrayBuffer&&!oa())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=t,this.resolvePrimitiveIndex=e.indirect?n=>this._indirectBuffer[n]:n=>n,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,e={...us,...e},e[Pr]||this.init(e)}init(t){let{geometry:e,primitiveStride:n}=this;if(t.indirect){let i=kr(e,t.range,n),s=Df(i,t.useSharedArrayBuffer);this._indirectBuffer=s}else la(e,t);super.init(t),!e.boundingBox&&t.setBoundingBox&&(e.boundingBox=this.getBoundingBox(new Tt))}getRootRanges(t){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:kr(this.geometry,t,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}};var Uf=1e5,Of=48,Gr=class r extends ys{constructor(t){let e=new ai;e.setIndex({count:t.length/6,array:null}),r.boxes=t;let n=t.length/6;super(e,{indirect:!0,strategy:n>Uf?0:2,maxDepth:Of-2,targetLeafSize:4,setBoundingBox:!1,verbose:!1,range:{start:0,count:n}}),r.boxes=null}get primitiveStride(){return 1}writePrimitiveBounds(t,e,n){let i=r.boxes,s=6*this._indirectBuffer[t];for(let o=0;o<6;o++)e[n+o]=i[s+o];return e}};function ca(r){let t=new Gr(r);return{nodes:new Uint32Array(t._roots[0]),order:Uint32Array.from(t._indirectBuffer)}}var Ff=2147483648,Bf=1,zf=2;function ua(r){let t=r.map(kf),e=u=>t.reduce((f,p)=>f+p[u],0),n={primitives:new Uint32Array(4*e("primitives")),places:new Float32Array(4*e("vertices")),normals:new Float32Array(4*e("corners")),boxes:new Float32Array(6*e("primitives")),records:[],texels:[],parts:[],largest:0,strands:0},i={primitive:0,vertex:0},s=[...r.keys()].sort((u,f)=>(r[u].kind==="fiber")-(r[f].kind==="fiber"));for(let u of s){let f=r[u];n.parts[u]={first:i.primitive,count:t[u].primitives,fiber:f.kind==="fiber"},f.kind==="fiber"?Wf(n,f.curves,i):Gf(n,f,i),i={primitive:i.primitive+t[u].primitives,vertex:i.vertex+t[u].vertices}}let{nodes:o,order:a}=ca(n.boxes),c=new Uint32Array(n.primitives.length);a.forEach((u,f)=>c.set(n.primitives.subarray(4*u,4*u+4),4*f));let l=new Uint32Array(a.length);return a.forEach((u,f)=>{l[u]=f}),{...n,boxes:null,primitives:c,nodes:o,where:l,texels:Vf(n.texels),records:Uint32Array.from(n.records.flat()),recordCount:n.records.length,epsilon:n.largest*2**-18,box:Xf(o)}}function kf({kind:r,mesh:t,curves:e}){if(r==="surface"){let i=t.positions.length/3;return{primitives:t.indices.length/3,vertices:i,corners:i}}let n=e.radii.length;return{primitives:n-(e.offsets.length-1),vertices:n,corners:0}}function Gf(r,{mesh:t,transmittance:e,normalMaps:n},{primitive:i,vertex:s}){let{positions:o,normals:a,uvs:c,indices:l}=t,{places:u,boxes:f,primitives:p}=r;for(let m=0;m<o.length/3;m++){let _=4*(s+m);for(let v=0;v<3;v++)u[_+v]=o[3*m+v],r.normals[_+v]=a[3*m+v],r.largest=Math.max(r.largest,Math.abs(o[3*m+v]));u[_+3]=c?c[2*m]:0,r.normals[_+3]=c?c[2*m+1]:0}for(let m=0;m<l.length/3;m++){let _=[0,1,2].map(v=>l[3*m+v]);p.set([..._.map(v=>v+s),i+m],4*(i+m));for(let v=0;v<3;v++){let b=_.map(w=>o[3*w+v]);f[6*(i+m)+v]=Math.min(...b),f[6*(i+m)+3+v]=Math.max(...b)}}for(let m of e)ha(r,m,i,0);for(let m of n)ha(r,m,i,1)}var fa=new Float32Array(1),Hf=new Uint32Array(fa.buffer);function Hr(r){return fa[0]=r,Hf[0]}function ha(r,{triangles:[t,e],texture:n,cutoff:i,ior:s},o,a){let c=r.texels.reduce((l,u)=>l+u.length,0);r.texels.push(n.values),r.records.push([a,o+t,o+t+e,c,n.width,n.height,n.channels,Hr(i??-1),Hr(s?.[0]??0),Hr(s?.[1]??0),0,0])}function Vf(r){let t=new Uint8Array(r.reduce((n,i)=>n+i.length,0)),e=0;for(let n of r)t.set(n,e),e+=n.length;return t}function Wf(r,{points:t,radii:e,offsets:n},{primitive:i,vertex:s}){let{places:o,boxes:a,primitives:c}=r;for(let u=0;u<e.length;u++){let[f,p,m]=t.subarray(3*u,3*u+3);o.set([f,p,m,e[u]],4*(s+u)),r.largest=Math.max(r.largest,Math.max(Math.abs(f),Math.abs(p),Math.abs(m))+e[u])}let l=i;for(let u=0;u+1<n.length;u++,r.strands++)for(let f=n[u];f+1<n[u+1];f++,l++){let p=(f>n[u]&&Bf)|(f+2<n[u+1]&&zf);c.set([s+f,r.strands,p,(l|Ff)>>>0],4*l);for(let m=0;m<3;m++){let _=t[3*f+m],v=t[3*f+3+m],b=e[f]*1.0005,w=e[f+1]*1.0005;a[6*l+m]=Math.min(_-b,v-w),a[6*l+3+m]=Math.max(_+b,v+w)}}}function Xf(r){let t=new Float32Array(r.buffer,0,6);return{min:[...t.subarray(0,3)],max:[...t.subarray(3,6)]}}var oe=Uint8Array,Bn=Uint16Array,$f=Int32Array,da=new oe([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),pa=new oe([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),qf=new oe([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ma=function(r,t){for(var e=new Bn(31),n=0;n<31;++n)e[n]=t+=1<<r[n-1];for(var i=new $f(e[30]),n=1;n<30;++n)for(var s=e[n];s<e[n+1];++s)i[s]=s-e[n]<<5|n;return{b:e,r:i}},ga=ma(da,2),_a=ga.b,Yf=ga.r;_a[28]=258,Yf[258]=28;var xa=ma(pa,0),Zf=xa.b,NS=xa.r,Xr=new Bn(32768);for(dt=0;dt<32768;++dt)Ue=(dt&43690)>>1|(dt&21845)<<1,Ue=(Ue&52428)>>2|(Ue&13107)<<2,Ue=(Ue&61680)>>4|(Ue&3855)<<4,Xr[dt]=((Ue&65280)>>8|(Ue&255)<<8)>>1;var Ue,dt,fi=(function(r,t,e){for(var n=r.length,i=0,s=new Bn(t);i<n;++i)r[i]&&++s[r[i]-1];var o=new Bn(t);for(i=1;i<t;++i)o[i]=o[i-1]+s[i-1]<<1;var a;if(e){a=new Bn(1<<t);var c=15-t;for(i=0;i<n;++i)if(r[i])for(var l=i<<4|r[i],u=t-r[i],f=o[r[i]-1]++<<u,p=f|(1<<u)-1;f<=p;++f)a[Xr[f]>>c]=l}else for(a=new Bn(n),i=0;i<n;++i)r[i]&&(a[i]=Xr[o[r[i]-1]++]>>15-r[i]);return a}),di=new oe(288);for(dt=0;dt<144;++dt)di[dt]=8;var dt;for(dt=144;dt<256;++dt)di[dt]=9;var dt;for(dt=256;dt<280;++dt)di[dt]=7;var dt;for(dt=280;dt<288;++dt)di[dt]=8;var dt,va=new oe(32);for(dt=0;dt<32;++dt)va[dt]=5;var dt;var Jf=fi(di,9,1);var Kf=fi(va,5,1),Vr=function(r){for(var t=r[0],e=1;e<r.length;++e)r[e]>t&&(t=r[e]);return t},me=function(r,t,e){var n=t/8|0;return(r[n]|r[n+1]<<8)>>(t&7)&e},Wr=function(r,t){var e=t/8|0;return(r[e]|r[e+1]<<8|r[e+2]<<16)>>(t&7)},jf=function(r){return(r+7)/8|0},Qf=function(r,t,e){return(t==null||t<0)&&(t=0),(e==null||e>r.length)&&(e=r.length),new oe(r.subarray(t,e))};var td=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ge=function(r,t,e){var n=new Error(t||td[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,ge),!e)throw n;return n},ed=function(r,t,e,n){var i=r.length,s=n?n.length:0;if(!i||t.f&&!t.l)return e||new oe(0);var o=!e,a=o||t.i!=2,c=t.i;o&&(e=new oe(i*3));var l=function(Si){var Mi=e.length;if(Si>Mi){var Jn=new oe(Math.max(Mi*2,Si));Jn.set(e),e=Jn}},u=t.f||0,f=t.p||0,p=t.b||0,m=t.l,_=t.d,v=t.m,b=t.n,w=i*8;do{if(!m){u=me(r,f,1);var T=me(r,f+1,3);if(f+=3,T)if(T==1)m=Jf,_=Kf,v=9,b=5;else if(T==2){var Y=me(r,f,31)+257,X=me(r,f+10,15)+4,O=Y+me(r,f+5,31)+1;f+=14;for(var L=new oe(O),k=new oe(19),F=0;F<X;++F)k[qf[F]]=me(r,f+F*3,7);f+=X*3;for(var B=Vr(k),et=(1<<B)-1,W=fi(k,B,1),F=0;F<O;){var j=W[me(r,f,et)];f+=j&15;var N=j>>4;if(N<16)L[F++]=N;else{var it=0,St=0;for(N==16?(St=3+me(r,f,3),f+=2,it=L[F-1]):N==17?(St=3+me(r,f,7),f+=3):N==18&&(St=11+me(r,f,127),f+=7);St--;)L[F++]=it}}var zt=L.subarray(0,Y),_t=L.subarray(Y);v=Vr(zt),b=Vr(_t),m=fi(zt,v,1),_=fi(_t,b,1)}else ge(1);else{var N=jf(f)+4,D=r[N-4]|r[N-3]<<8,U=N+D;if(U>i){c&&ge(0);break}a&&l(p+D),e.set(r.subarray(N,U),p),t.b=p+=D,t.p=f=U*8,t.f=u;continue}if(f>w){c&&ge(0);break}}a&&l(p+131072);for(var Rt=(1<<v)-1,_e=(1<<b)-1,Mt=f;;Mt=f){var it=m[Wr(r,f)&Rt],bt=it>>4;if(f+=it&15,f>w){c&&ge(0);break}if(it||ge(2),bt<256)e[p++]=bt;else if(bt==256){Mt=f,m=null;break}else{var Ht=bt-254;if(bt>264){var F=bt-257,Ae=da[F];Ht=me(r,f,(1<<Ae)-1)+_a[F],f+=Ae}var tn=_[Wr(r,f)&_e],mn=tn>>4;tn||ge(3),f+=tn&15;var _t=Zf[mn];if(mn>3){var Ae=pa[mn];_t+=Wr(r,f)&(1<<Ae)-1,f+=Ae}if(f>w){c&&ge(0);break}a&&l(p+131072);var mt=p+Ht;if(p<_t){var Te=s-_t,Be=Math.min(_t,mt);for(Te+p<0&&ge(3);p<Be;++p)e[p]=n[Te+p]}for(;p<mt;++p)e[p]=e[p-_t]}}t.l=m,t.p=Mt,t.b=p,t.f=u,m&&(u=1,t.m=v,t.d=_,t.n=b)}while(!u);return p!=e.length&&o?Qf(e,0,p):e.subarray(0,p)};var nd=new oe(0);var id=function(r,t){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&ge(6,"invalid zlib data"),(r[1]>>5&1)==+!t&&ge(6,"invalid zlib data: "+(r[1]&32?"need":"unexpected")+" dictionary"),(r[1]>>3&4)+2};function zn(r,t){return ed(r.subarray(id(r,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var sd=typeof TextDecoder<"u"&&new TextDecoder,rd=0;try{sd.decode(nd,{stream:!0}),rd=1}catch{}var Ss=class extends cn{constructor(t){super(t),this.type=fe,this.outputFormat=ye,this.part=0}parse(t){let L=Math.pow(2.7182818,2.2),k=null,F=null;function B(h,d){let g=0;for(let M=0;M<65536;++M)(M==0||h[M>>3]&1<<(M&7))&&(d[g++]=M);let y=g-1;for(;g<65536;)d[g++]=0;return y}function et(h){for(let d=0;d<16384;d++)h[d]={},h[d].len=0,h[d].lit=0,h[d].p=null}let W={l:0,c:0,lc:0};function j(h,d,g,y,M){for(;g<h;)d=d<<8|po(y,M),g+=8;g-=h,W.l=d>>g&(1<<h)-1,W.c=d,W.lc=g}let it=new Array(59);function St(h){for(let g=0;g<=58;++g)it[g]=0;for(let g=0;g<65537;++g)it[h[g]]+=1;let d=0;for(let g=58;g>0;--g){let y=d+it[g]>>1;it[g]=d,d=y}for(let g=0;g<65537;++g){let y=h[g];y>0&&(h[g]=y|it[y]++<<6)}}function zt(h,d,g,y,M,A){let x=d,C=0,E=0;for(;y<=M;y++){if(x.value-d.value>g)return!1;j(6,C,E,h,x);let R=W.l;if(C=W.c,E=W.lc,A[y]=R,R==63){if(x.value-d.value>g)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");j(8,C,E,h,x);let I=W.l+6;if(C=W.c,E=W.lc,y+I>M+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;I--;)A[y++]=0;y--}else if(R>=59){let I=R-59+2;if(y+I>M+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;I--;)A[y++]=0;y--}}St(A)}function _t(h){return h&63}function Rt(h){return h>>6}function _e(h,d,g,y){for(;d<=g;d++){let M=Rt(h[d]),A=_t(h[d]);if(M>>A)throw new Error("THREE.EXRLoader: Invalid table entry");if(A>14){let x=y[M>>A-14];if(x.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(x.lit++,x.p){let C=x.p;x.p=new Array(x.lit);for(let E=0;E<x.lit-1;++E)x.p[E]=C[E]}else x.p=new Array(1);x.p[x.lit-1]=d}else if(A){let x=0;for(let C=1<<14-A;C>0;C--){let E=y[(M<<14-A)+x];if(E.len||E.p)throw new Error("THREE.EXRLoader: Invalid table entry");E.len=A,E.lit=d,x++}}}return!0}let Mt={c:0,lc:0};function bt(h,d,g,y){h=h<<8|po(g,y),d+=8,Mt.c=h,Mt.lc=d}let Ht={c:0,lc:0};function Ae(h,d,g,y,M,A,x,C,E){if(h==d){y<8&&(bt(g,y,M,A),g=Mt.c,y=Mt.lc),y-=8;let R=g>>y;if(R=new Uint8Array([R])[0],C.value+R>E)return!1;let I=x[C.value-1];for(;R-- >0;)x[C.value++]=I}else if(C.value<E)x[C.value++]=h;else return!1;Ht.c=g,Ht.lc=y}function tn(h){return h&65535}function mn(h){let d=tn(h);return d>32767?d-65536:d}let mt={a:0,b:0};function Te(h,d){let g=mn(h),M=mn(d),A=g+(M&1)+(M>>1),x=A,C=A-M;mt.a=x,mt.b=C}function Be(h,d){let g=tn(h),y=tn(d),M=g-(y>>1)&65535,A=y+M-32768&65535;mt.a=A,mt.b=M}function Si(h,d,g,y,M,A,x){let C=x<16384,E=g>M?M:g,R=1,I,z;for(;R<=E;)R<<=1;for(R>>=1,I=R,R>>=1;R>=1;){z=0;let P=z+A*(M-I),V=A*R,J=A*I,H=y*R,q=y*I,nt,at,st,ut;for(;z<=P;z+=J){let Q=z,K=z+y*(g-I);for(;Q<=K;Q+=q){let tt=Q+H,pt=Q+V,ft=pt+H;C?(Te(h[Q+d],h[pt+d]),nt=mt.a,st=mt.b,Te(h[tt+d],h[ft+d]),at=mt.a,ut=mt.b,Te(nt,at),h[Q+d]=mt.a,h[tt+d]=mt.b,Te(st,ut),h[pt+d]=mt.a,h[ft+d]=mt.b):(Be(h[Q+d],h[pt+d]),nt=mt.a,st=mt.b,Be(h[tt+d],h[ft+d]),at=mt.a,ut=mt.b,Be(nt,at),h[Q+d]=mt.a,h[tt+d]=mt.b,Be(st,ut),h[pt+d]=mt.a,h[ft+d]=mt.b)}if(g&R){let tt=Q+V;C?Te(h[Q+d],h[tt+d]):Be(h[Q+d],h[tt+d]),nt=mt.a,h[tt+d]=mt.b,h[Q+d]=nt}}if(M&R){let Q=z,K=z+y*(g-I);for(;Q<=K;Q+=q){let tt=Q+H;C?Te(h[Q+d],h[tt+d]):Be(h[Q+d],h[tt+d]),nt=mt.a,h[tt+d]=mt.b,h[Q+d]=nt}}I=R,R>>=1}return z}function Mi(h,d,g,y,M,A,x,C,E){let R=0,I=0,z=x,P=Math.trunc(y.value+(M+7)/8);for(;y.value<P;)for(bt(R,I,g,y),R=Mt.c,I=Mt.lc;I>=14;){let J=R>>I-14&16383,H=d[J];if(H.len)I-=H.len,Ae(H.lit,A,R,I,g,y,C,E,z),R=Ht.c,I=Ht.lc;else{if(!H.p)throw new Error("THREE.EXRLoader: hufDecode issues");let q;for(q=0;q<H.lit;q++){let nt=_t(h[H.p[q]]);for(;I<nt&&y.value<P;)bt(R,I,g,y),R=Mt.c,I=Mt.lc;if(I>=nt&&Rt(h[H.p[q]])==(R>>I-nt&(1<<nt)-1)){I-=nt,Ae(H.p[q],A,R,I,g,y,C,E,z),R=Ht.c,I=Ht.lc;break}}if(q==H.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let V=8-M&7;for(R>>=V,I-=V;I>0;){let J=d[R<<14-I&16383];if(J.len)I-=J.len,Ae(J.lit,A,R,I,g,y,C,E,z),R=Ht.c,I=Ht.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Jn(h,d,g,y,M,A){let x={value:0},C=g.value,E=$t(d,g),R=$t(d,g);g.value+=4;let I=$t(d,g);if(g.value+=4,E<0||E>=65537||R<0||R>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let z=new Array(65537),P=new Array(16384);et(P);let V=y-(g.value-C);if(zt(h,g,V,E,R,z),I>8*(y-(g.value-C)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");_e(z,E,R,P),Mi(z,P,h,g,I,R,A,M,x)}function Pl(h,d,g){for(let y=0;y<g;++y)d[y]=h[d[y]]}function bi(h){for(let d=1;d<h.length;d++){let g=h[d-1]+h[d]-128;h[d]=g}}function wi(h,d){let g=0,y=Math.floor((h.length+1)/2),M=0,A=h.length-1;for(;!(M>A||(d[M++]=h[g++],M>A));)d[M++]=h[y++]}function Os(h){let d=h.byteLength,g=new Array,y=0,M=new DataView(h);for(;d>0;){let A=M.getInt8(y++);if(A<0){let x=-A;d-=x+1;for(let C=0;C<x;C++)g.push(M.getUint8(y++))}else{let x=A;d-=2;let C=M.getUint8(y++);for(let E=0;E<x+1;E++)g.push(C)}}return g}function Ll(h,d,g,y,M,A){let x=new DataView(A.buffer),C=g[h.idx[0]].width,E=g[h.idx[0]].height,R=3,I=Math.floor(C/8),z=Math.ceil(C/8),P=Math.ceil(E/8),V=C-(z-1)*8,J=E-(P-1)*8,H={value:0},q=new Array(R),nt=new Array(R),at=new Array(R),st=new Array(R),ut=new Array(R);for(let K=0;K<R;++K)ut[K]=d[h.idx[K]],q[K]=K<1?0:q[K-1]+z*P,nt[K]=new Float32Array(64),at[K]=new Uint16Array(64),st[K]=new Uint16Array(z*64);for(let K=0;K<P;++K){let tt=8;K==P-1&&(tt=J);let pt=8;for(let rt=0;rt<z;++rt){rt==z-1&&(pt=V);for(let lt=0;lt<R;++lt)at[lt].fill(0),at[lt][0]=M[q[lt]++],oo(H,y,at[lt]),ao(at[lt],nt[lt]),lo(nt[lt]);R==3&&Dl(nt);for(let lt=0;lt<R;++lt)uo(nt[lt],st[lt],rt*64)}let ft=0;for(let rt=0;rt<R;++rt){let lt=g[h.idx[rt]].type;for(let wt=8*K;wt<8*K+tt;++wt){ft=ut[rt][wt];for(let qt=0;qt<I;++qt){let gt=qt*64+(wt&7)*8;x.setUint16(ft+0*lt,st[rt][gt+0],!0),x.setUint16(ft+2*lt,st[rt][gt+1],!0),x.setUint16(ft+4*lt,st[rt][gt+2],!0),x.setUint16(ft+6*lt,st[rt][gt+3],!0),x.setUint16(ft+8*lt,st[rt][gt+4],!0),x.setUint16(ft+10*lt,st[rt][gt+5],!0),x.setUint16(ft+12*lt,st[rt][gt+6],!0),x.setUint16(ft+14*lt,st[rt][gt+7],!0),ft+=16*lt}}if(I!=z)for(let wt=8*K;wt<8*K+tt;++wt){let qt=ut[rt][wt]+8*I*2*lt,gt=I*64+(wt&7)*8;for(let xe=0;xe<pt;++xe)x.setUint16(qt+xe*2*lt,st[rt][gt+xe],!0)}}}let Q=new Uint16Array(C);x=new DataView(A.buffer);for(let K=0;K<R;++K){g[h.idx[K]].decoded=!0;let tt=g[h.idx[K]].type;if(g[K].type==2)for(let pt=0;pt<E;++pt){let ft=ut[K][pt];for(let rt=0;rt<C;++rt)Q[rt]=x.getUint16(ft+rt*2*tt,!0);for(let rt=0;rt<C;++rt)x.setFloat32(ft+rt*2*tt,G.fromHalfFloat(Q[rt]),!0)}}}function Nl(h,d,g,y,M,A){let x=new DataView(A.buffer),C=g[h],E=C.width,R=C.height,I=Math.ceil(E/8),z=Math.ceil(R/8),P=Math.floor(E/8),V=E-(I-1)*8,J=R-(z-1)*8,H={value:0},q=0,nt=new Float32Array(64),at=new Uint16Array(64),st=new Uint16Array(I*64);for(let ut=0;ut<z;++ut){let Q=8;ut==z-1&&(Q=J);for(let K=0;K<I;++K)at.fill(0),at[0]=M[q++],oo(H,y,at),ao(at,nt),lo(nt),uo(nt,st,K*64);for(let K=8*ut;K<8*ut+Q;++K){let tt=d[h][K];for(let pt=0;pt<P;++pt){let ft=pt*64+(K&7)*8;for(let rt=0;rt<8;++rt)x.setUint16(tt+rt*2*C.type,st[ft+rt],!0);tt+=16*C.type}if(I!=P){let pt=P*64+(K&7)*8;for(let ft=0;ft<V;++ft)x.setUint16(tt+ft*2*C.type,st[pt+ft],!0)}}}C.decoded=!0}function oo(h,d,g){let y,M=1;for(;M<64;)y=d[h.value],y==65280?M=64:y>>8==255?M+=y&255:(g[M]=y,M++),h.value++}function ao(h,d){d[0]=G.fromHalfFloat(h[0]),d[1]=G.fromHalfFloat(h[1]),d[2]=G.fromHalfFloat(h[5]),d[3]=G.fromHalfFloat(h[6]),d[4]=G.fromHalfFloat(h[14]),d[5]=G.fromHalfFloat(h[15]),d[6]=G.fromHalfFloat(h[27]),d[7]=G.fromHalfFloat(h[28]),d[8]=G.fromHalfFloat(h[2]),d[9]=G.fromHalfFloat(h[4]),d[10]=G.fromHalfFloat(h[7]),d[11]=G.fromHalfFloat(h[13]),d[12]=G.fromHalfFloat(h[16]),d[13]=G.fromHalfFloat(h[26]),d[14]=G.fromHalfFloat(h[29]),d[15]=G.fromHalfFloat(h[42]),d[16]=G.fromHalfFloat(h[3]),d[17]=G.fromHalfFloat(h[8]),d[18]=G.fromHalfFloat(h[12]),d[19]=G.fromHalfFloat(h[17]),d[20]=G.fromHalfFloat(h[25]),d[21]=G.fromHalfFloat(h[30]),d[22]=G.fromHalfFloat(h[41]),d[23]=G.fromHalfFloat(h[43]),d[24]=G.fromHalfFloat(h[9]),d[25]=G.fromHalfFloat(h[11]),d[26]=G.fromHalfFloat(h[18]),d[27]=G.fromHalfFloat(h[24]),d[28]=G.fromHalfFloat(h[31]),d[29]=G.fromHalfFloat(h[40]),d[30]=G.fromHalfFloat(h[44]),d[31]=G.fromHalfFloat(h[53]),d[32]=G.fromHalfFloat(h[10]),d[33]=G.fromHalfFloat(h[19]),d[34]=G.fromHalfFloat(h[23]),d[35]=G.fromHalfFloat(h[32]),d[36]=G.fromHalfFloat(h[39]),d[37]=G.fromHalfFloat(h[45]),d[38]=G.fromHalfFloat(h[52]),d[39]=G.fromHalfFloat(h[54]),d[40]=G.fromHalfFloat(h[20]),d[41]=G.fromHalfFloat(h[22]),d[42]=G.fromHalfFloat(h[33]),d[43]=G.fromHalfFloat(h[38]),d[44]=G.fromHalfFloat(h[46]),d[45]=G.fromHalfFloat(h[51]),d[46]=G.fromHalfFloat(h[55]),d[47]=G.fromHalfFloat(h[60]),d[48]=G.fromHalfFloat(h[21]),d[49]=G.fromHalfFloat(h[34]),d[50]=G.fromHalfFloat(h[37]),d[51]=G.fromHalfFloat(h[47]),d[52]=G.fromHalfFloat(h[50]),d[53]=G.fromHalfFloat(h[56]),d[54]=G.fromHalfFloat(h[59]),d[55]=G.fromHalfFloat(h[61]),d[56]=G.fromHalfFloat(h[35]),d[57]=G.fromHalfFloat(h[36]),d[58]=G.fromHalfFloat(h[48]),d[59]=G.fromHalfFloat(h[49]),d[60]=G.fromHalfFloat(h[57]),d[61]=G.fromHalfFloat(h[58]),d[62]=G.fromHalfFloat(h[62]),d[63]=G.fromHalfFloat(h[63])}function lo(h){let d=.5*Math.cos(.7853975),g=.5*Math.cos(3.14159/16),y=.5*Math.cos(3.14159/8),M=.5*Math.cos(3*3.14159/16),A=.5*Math.cos(5*3.14159/16),x=.5*Math.cos(3*3.14159/8),C=.5*Math.cos(7*3.14159/16),E=new Array(4),R=new Array(4),I=new Array(4),z=new Array(4);for(let P=0;P<8;++P){let V=P*8;E[0]=y*h[V+2],E[1]=x*h[V+2],E[2]=y*h[V+6],E[3]=x*h[V+6],R[0]=g*h[V+1]+M*h[V+3]+A*h[V+5]+C*h[V+7],R[1]=M*h[V+1]-C*h[V+3]-g*h[V+5]-A*h[V+7],R[2]=A*h[V+1]-g*h[V+3]+C*h[V+5]+M*h[V+7],R[3]=C*h[V+1]-A*h[V+3]+M*h[V+5]-g*h[V+7],I[0]=d*(h[V+0]+h[V+4]),I[3]=d*(h[V+0]-h[V+4]),I[1]=E[0]+E[3],I[2]=E[1]-E[2],z[0]=I[0]+I[1],z[1]=I[3]+I[2],z[2]=I[3]-I[2],z[3]=I[0]-I[1],h[V+0]=z[0]+R[0],h[V+1]=z[1]+R[1],h[V+2]=z[2]+R[2],h[V+3]=z[3]+R[3],h[V+4]=z[3]-R[3],h[V+5]=z[2]-R[2],h[V+6]=z[1]-R[1],h[V+7]=z[0]-R[0]}for(let P=0;P<8;++P)E[0]=y*h[16+P],E[1]=x*h[16+P],E[2]=y*h[48+P],E[3]=x*h[48+P],R[0]=g*h[8+P]+M*h[24+P]+A*h[40+P]+C*h[56+P],R[1]=M*h[8+P]-C*h[24+P]-g*h[40+P]-A*h[56+P],R[2]=A*h[8+P]-g*h[24+P]+C*h[40+P]+M*h[56+P],R[3]=C*h[8+P]-A*h[24+P]+M*h[40+P]-g*h[56+P],I[0]=d*(h[P]+h[32+P]),I[3]=d*(h[P]-h[32+P]),I[1]=E[0]+E[3],I[2]=E[1]-E[2],z[0]=I[0]+I[1],z[1]=I[3]+I[2],z[2]=I[3]-I[2],z[3]=I[0]-I[1],h[0+P]=z[0]+R[0],h[8+P]=z[1]+R[1],h[16+P]=z[2]+R[2],h[24+P]=z[3]+R[3],h[32+P]=z[3]-R[3],h[40+P]=z[2]-R[2],h[48+P]=z[1]-R[1],h[56+P]=z[0]-R[0]}function Dl(h){for(let d=0;d<64;++d){let g=h[0][d],y=h[1][d],M=h[2][d];h[0][d]=g+1.5747*M,h[1][d]=g-.1873*y-.4682*M,h[2][d]=g+1.8556*y}}let Fs=new Float32Array(1),co=new Uint32Array(Fs.buffer);function ho(h){Fs[0]=h;let d=co[0],g=d>>>16&32768,y=d&2147483647;if(y>=1199570944)return g|(y>2139095040?32256:31744);if(y<947912704)return Fs[0]=Math.abs(h)+.5,g|co[0]-1056964608;let M=y+4095+(y>>>13&1);return g|M-939524096>>>13}function uo(h,d,g){if(F===null){F=new Uint16Array(65536);for(let y=1;y<65536;++y){if((y&31744)===31744)continue;let M=G.fromHalfFloat(y),A=Math.abs(M),x=A<=1?Math.pow(A,2.2):Math.pow(L,A-1);F[y]=ho(M<0?-x:x)}}for(let y=0;y<64;++y)d[g+y]=F[ho(h[y])]}function Ei(h){return new DataView(h.array.buffer,h.offset.value,h.size)}function Ul(h){let d=h.viewer.buffer.slice(h.offset.value,h.offset.value+h.size),g=new Uint8Array(Os(d)),y=new Uint8Array(g.length);return bi(g),wi(g,y),new DataView(y.buffer)}function Bs(h){let d=h.array.slice(h.offset.value,h.offset.value+h.size),g=zn(d),y=new Uint8Array(g.length);return bi(g),wi(g,y),new DataView(y.buffer)}function Ol(h){let d=h.viewer,g={value:h.offset.value},y=new Uint16Array(h.columns*h.lines*(h.inputChannels.length*h.type)),M=new Uint8Array(8192),A=0,x=new Array(h.inputChannels.length);for(let J=0,H=h.inputChannels.length;J<H;J++)x[J]={},x[J].start=A,x[J].end=x[J].start,x[J].nx=h.columns,x[J].ny=h.lines,x[J].size=h.type,A+=x[J].nx*x[J].ny*x[J].size;let C=Kn(d,g),E=Kn(d,g);if(E>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(C<=E)for(let J=0;J<E-C+1;J++)M[J+C]=ze(d,g);let R=new Uint16Array(65536),I=B(M,R),z=$t(d,g);Jn(h.array,d,g,z,y,A);for(let J=0;J<h.inputChannels.length;++J){let H=x[J];for(let q=0;q<x[J].size;++q)Si(y,H.start+q,H.nx,H.size,H.ny,H.nx*H.size,I)}Pl(R,y,A);let P=0,V=new Uint8Array(y.buffer.byteLength);for(let J=0;J<h.lines;J++)for(let H=0;H<h.inputChannels.length;H++){let q=x[H],nt=q.nx*q.size,at=new Uint8Array(y.buffer,q.end*2,nt*2);V.set(at,P),P+=nt*2,q.end+=nt}return new DataView(V.buffer)}function Fl(h){let d=h.array.slice(h.offset.value,h.offset.value+h.size),g=zn(d),y=h.inputChannels.length*h.lines*h.columns*h.totalBytes,M=new ArrayBuffer(y),A=new DataView(M),x=0,C=0,E=new Array(4);for(let R=0;R<h.lines;R++)for(let I=0;I<h.inputChannels.length;I++){let z=0;switch(h.inputChannels[I].pixelType){case 1:E[0]=x,E[1]=E[0]+h.columns,x=E[1]+h.columns;for(let V=0;V<h.columns;++V){let J=g[E[0]++]<<8|g[E[1]++];z+=J,A.setUint16(C,z,!0),C+=2}break;case 2:E[0]=x,E[1]=E[0]+h.columns,E[2]=E[1]+h.columns,x=E[2]+h.columns;for(let V=0;V<h.columns;++V){let J=g[E[0]++]<<24|g[E[1]++]<<16|g[E[2]++]<<8;z+=J,A.setUint32(C,z,!0),C+=4}break}}return A}function Bl(h){let d=h.array,g=h.offset.value,y=h.columns,M=h.lines,A=h.inputChannels,x=h.totalBytes,C=Ut.compression==="B44A_COMPRESSION",E=new Uint8Array(M*y*x),R=new Uint16Array(16),I=0;for(let z=0;z<A.length;z++){let P=A[z],V=P.pixelType*2,J=Math.ceil(y/P.xSampling),H=Math.ceil(M/P.ySampling),q=P.xSampling===1&&P.ySampling===1;if(P.pixelType!==1){for(let st=0;st<H;st++)if(q){let ut=st*y*x+I*y;for(let Q=0;Q<J*V;Q++)E[ut+Q]=d[g++]}else g+=J*V;I+=V;continue}let nt=Math.ceil(J/4),at=Math.ceil(H/4);for(let st=0;st<at;st++)for(let ut=0;ut<nt;ut++){if(C&&d[g+2]>=52){let Q=d[g]<<8|d[g+1],K=Q&32768?Q&32767:~Q&65535;R.fill(K),g+=3}else{let Q=d[g]<<8|d[g+1],K=d[g+2]>>2,tt=32<<K,pt=Q+((d[g+2]<<4|d[g+3]>>4)&63)*(1<<K)-tt&65535,ft=pt+((d[g+3]<<2|d[g+4]>>6)&63)*(1<<K)-tt&65535,rt=ft+(d[g+4]&63)*(1<<K)-tt&65535,lt=Q+(d[g+5]>>2&63)*(1<<K)-tt&65535,wt=pt+((d[g+5]<<4|d[g+6]>>4)&63)*(1<<K)-tt&65535,qt=ft+((d[g+6]<<2|d[g+7]>>6)&63)*(1<<K)-tt&65535,gt=rt+(d[g+7]&63)*(1<<K)-tt&65535,xe=lt+(d[g+8]>>2&63)*(1<<K)-tt&65535,gn=wt+((d[g+8]<<4|d[g+9]>>4)&63)*(1<<K)-tt&65535,jn=qt+((d[g+9]<<2|d[g+10]>>6)&63)*(1<<K)-tt&65535,ve=gt+(d[g+10]&63)*(1<<K)-tt&65535,en=xe+(d[g+11]>>2&63)*(1<<K)-tt&65535,Ii=gn+((d[g+11]<<4|d[g+12]>>4)&63)*(1<<K)-tt&65535,Pi=jn+((d[g+12]<<2|d[g+13]>>6)&63)*(1<<K)-tt&65535,Li=ve+(d[g+13]&63)*(1<<K)-tt&65535,Qn=[Q,lt,xe,en,pt,wt,gn,Ii,ft,qt,jn,Pi,rt,gt,ve,Li];for(let _n=0;_n<16;_n++)R[_n]=Qn[_n]&32768?Qn[_n]&32767:~Qn[_n]&65535;g+=14}if(P.pLinear){if(k===null){k=new Uint16Array(65536);for(let Q=0;Q<65536;Q++)if((Q&31744)===31744||Q>32768)k[Q]=0;else{let K=G.fromHalfFloat(Q);k[Q]=K<=0?0:G.toHalfFloat(8*Math.log(K))}}for(let Q=0;Q<16;Q++)R[Q]=k[R[Q]]}for(let Q=0;Q<4;Q++){let K=st*4+Q;if(!(K>=H))for(let tt=0;tt<4;tt++){let pt=ut*4+tt;if(pt>=J)continue;let ft=R[Q*4+tt];for(let rt=0;rt<P.ySampling;rt++){let lt=K*P.ySampling+rt;if(!(lt>=M))for(let wt=0;wt<P.xSampling;wt++){let qt=pt*P.xSampling+wt;if(qt>=y)continue;let gt=lt*y*x+I*y+qt*2;E[gt]=ft&255,E[gt+1]=ft>>8&255}}}}}I+=2}return new DataView(E.buffer)}function fo(h){let d=h.viewer,g={value:h.offset.value},y=new Uint8Array(h.columns*h.lines*(h.inputChannels.length*h.type*2)),M={version:Pt(d,g),unknownUncompressedSize:Pt(d,g),unknownCompressedSize:Pt(d,g),acCompressedSize:Pt(d,g),dcCompressedSize:Pt(d,g),rleCompressedSize:Pt(d,g),rleUncompressedSize:Pt(d,g),rleRawSize:Pt(d,g),totalAcUncompressedCount:Pt(d,g),totalDcUncompressedCount:Pt(d,g),acCompression:Pt(d,g)};if(M.version<2)throw new Error("THREE.EXRLoader: "+Ut.compression+" version "+M.version+" is unsupported");let A=new Array,x=Kn(d,g)-2;for(;x>0;){let H=Ai(d.buffer,g),q=ze(d,g),nt=q>>2&3,at=(q>>4)-1,st=new Int8Array([at])[0],ut=ze(d,g);A.push({name:H,index:st,type:ut,compression:nt}),x-=H.length+3}let C=Ut.channels,E=new Array(h.inputChannels.length);for(let H=0;H<h.inputChannels.length;++H){let q=E[H]={},nt=C[H];q.name=nt.name,q.compression=0,q.decoded=!1,q.type=nt.pixelType,q.pLinear=nt.pLinear,q.width=h.columns,q.height=h.lines}let R={idx:new Array(3)};for(let H=0;H<h.inputChannels.length;++H){let q=E[H],nt=q.name.lastIndexOf("."),at=nt>=0?q.name.substring(nt+1):q.name;for(let st=0;st<A.length;++st){let ut=A[st];at===ut.name&&q.type===ut.type&&(q.compression=ut.compression,ut.index>=0&&(R.idx[ut.index]=H),q.offset=H)}}let I,z,P;if(M.acCompressedSize>0)switch(M.acCompression){case 0:I=new Uint16Array(M.totalAcUncompressedCount),Jn(h.array,d,g,M.acCompressedSize,I,M.totalAcUncompressedCount);break;case 1:let H=h.array.slice(g.value,g.value+M.totalAcUncompressedCount),q=zn(H);I=new Uint16Array(q.buffer),g.value+=M.totalAcUncompressedCount;break}if(M.dcCompressedSize>0){let H={array:h.array,offset:g,size:M.dcCompressedSize};z=new Uint16Array(Bs(H).buffer),g.value+=M.dcCompressedSize}if(M.rleRawSize>0){let H=h.array.slice(g.value,g.value+M.rleCompressedSize),q=zn(H);P=Os(q.buffer),g.value+=M.rleCompressedSize}let V=0,J=new Array(E.length);for(let H=0;H<J.length;++H)J[H]=new Array;for(let H=0;H<h.lines;++H)for(let q=0;q<E.length;++q)J[q].push(V),V+=E[q].width*h.type*2;R.idx[0]!==void 0&&E[R.idx[0]]&&Ll(R,J,E,I,z,y);for(let H=0;H<E.length;++H){let q=E[H];if(!q.decoded)switch(q.compression){case 2:let nt=0,at=0;for(let st=0;st<h.lines;++st){let ut=J[H][nt];for(let Q=0;Q<q.width;++Q){for(let K=0;K<2*q.type;++K)y[ut++]=P[at+K*q.width*q.height];at++}nt++}break;case 1:Nl(H,J,E,I,z,y);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(y.buffer)}function Ai(h,d){let g=new Uint8Array(h),y=0;for(;g[d.value+y]!=0;)y+=1;let M=new TextDecoder().decode(g.slice(d.value,d.value+y));return d.value=d.value+y+1,M}function zl(h,d,g){let y=new TextDecoder().decode(new Uint8Array(h).slice(d.value,d.value+g));return d.value=d.value+g,y}function kl(h,d){let g=Vt(h,d),y=$t(h,d);return[g,y]}function Gl(h,d){let g=$t(h,d),y=$t(h,d);return[g,y]}function Vt(h,d){let g=h.getInt32(d.value,!0);return d.value=d.value+4,g}function $t(h,d){let g=h.getUint32(d.value,!0);return d.value=d.value+4,g}function po(h,d){let g=h[d.value];return d.value=d.value+1,g}function ze(h,d){let g=h.getUint8(d.value);return d.value=d.value+1,g}let Pt=function(h,d){let g=Number(h.getBigInt64(d.value,!0));return d.value+=8,g};function Dt(h,d){let g=h.getFloat32(d.value,!0);return d.value+=4,g}function Hl(h,d){return G.toHalfFloat(Dt(h,d))}function Kn(h,d){let g=h.getUint16(d.value,!0);return d.value+=2,g}function Vl(h,d){return G.fromHalfFloat(Kn(h,d))}function Wl(h,d,g,y){let M=g.value,A=[];for(;g.value<M+y-1;){let x=Ai(d,g),C=Vt(h,g),E=ze(h,g);g.value+=3;let R=Vt(h,g),I=Vt(h,g);A.push({name:x,pixelType:C,pLinear:E,xSampling:R,ySampling:I})}return g.value+=1,A}function Xl(h,d){let g=Dt(h,d),y=Dt(h,d),M=Dt(h,d),A=Dt(h,d),x=Dt(h,d),C=Dt(h,d),E=Dt(h,d),R=Dt(h,d);return{redX:g,redY:y,greenX:M,greenY:A,blueX:x,blueY:C,whiteX:E,whiteY:R}}function $l(h,d){let g=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],y=ze(h,d);return g[y]}function ql(h,d){let g=Vt(h,d),y=Vt(h,d),M=Vt(h,d),A=Vt(h,d);return{xMin:g,yMin:y,xMax:M,yMax:A}}function Yl(h,d){let g=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],y=ze(h,d);return g[y]}function Zl(h,d){let g=["ENVMAP_LATLONG","ENVMAP_CUBE"],y=ze(h,d);return g[y]}function Jl(h,d){let g=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],y=["ROUND_DOWN","ROUND_UP"],M=$t(h,d),A=$t(h,d),x=ze(h,d);return{xSize:M,ySize:A,levelMode:g[x&15],roundingMode:y[x>>4]}}function Kl(h,d){let g=Dt(h,d),y=Dt(h,d);return[g,y]}function jl(h,d){let g=Dt(h,d),y=Dt(h,d),M=Dt(h,d);return[g,y,M]}function Ql(h,d,g,y,M){if(y==="string"||y==="stringvector"||y==="iccProfile")return zl(d,g,M);if(y==="chlist")return Wl(h,d,g,M);if(y==="chromaticities")return Xl(h,g);if(y==="compression")return $l(h,g);if(y==="box2i")return ql(h,g);if(y==="envmap")return Zl(h,g);if(y==="tiledesc")return Jl(h,g);if(y==="lineOrder")return Yl(h,g);if(y==="float")return Dt(h,g);if(y==="v2f")return Kl(h,g);if(y==="v3f")return jl(h,g);if(y==="int")return Vt(h,g);if(y==="rational")return kl(h,g);if(y==="timecode")return Gl(h,g);if(y==="preview"||y==="deepImageState"||y==="idmanifest")return g.value+=M,"skipped";g.value+=M}function tc(h,d){let g=Math.log2(h);return d=="ROUND_DOWN"?Math.floor(g):Math.ceil(g)}function ec(h,d,g){let y=0;switch(h.levelMode){case"ONE_LEVEL":y=1;break;case"MIPMAP_LEVELS":y=tc(Math.max(d,g),h.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return y}function mo(h,d,g,y){let M=new Array(h);for(let A=0;A<h;A++){let x=1<<A,C=d/x|0;y=="ROUND_UP"&&C*x<d&&(C+=1);let E=Math.max(C,1);M[A]=(E+g-1)/g|0}return M}function nc(){let h=this,d=h.offset,g={value:0};for(let y=0;y<h.tileCount;y++){let M=Vt(h.viewer,d),A=Vt(h.viewer,d);d.value+=8,h.size=$t(h.viewer,d);let x=M*h.blockWidth,C=A*h.blockHeight;h.columns=x+h.blockWidth>h.width?h.width-x:h.blockWidth,h.lines=C+h.blockHeight>h.height?h.height-C:h.blockHeight;let E=h.columns*h.totalBytes,I=h.size<h.lines*E?h.uncompress(h):Ei(h);d.value+=h.size;for(let z=0;z<h.lines;z++){let P=z*h.columns*h.totalBytes;for(let V=0;V<h.inputChannels.length;V++){let J=Ut.channels[V].name,H=h.channelByteOffsets[J]*h.columns,q=h.decodeChannels[J];if(q===void 0)continue;g.value=P+H;let nt=(h.height-(1+C+z))*h.outLineWidth;for(let at=0;at<h.columns;at++){let st=nt+(at+x)*h.outputChannels+q;h.byteArray[st]=h.getter(I,g)}}}}}function ic(){let h=this,d=h.offset,g={value:0};for(let y=0;y<h.height/h.blockHeight;y++){let M=Vt(h.viewer,d)-Ut.dataWindow.yMin;h.size=$t(h.viewer,d),h.lines=M+h.blockHeight>h.height?h.height-M:h.blockHeight;let A=h.columns*h.totalBytes,C=h.size<h.lines*A?h.uncompress(h):Ei(h);d.value+=h.size;for(let E=0;E<h.lines;E++){let R=M+E,I=E*A,z=(h.height-1-R)*h.outLineWidth;for(let P=0;P<h.inputChannels.length;P++){let V=Ut.channels[P].name,J=h.channelByteOffsets[V]*h.columns,H=h.decodeChannels[V];if(H!==void 0){g.value=I+J;for(let q=0;q<h.columns;q++){let nt=z+q*h.outputChannels+H;h.byteArray[nt]=h.getter(C,g)}}}}}}function sc(){let h=this,d=h.chunkOffsets,g={value:0};for(let y=0;y<d.length;y++){let M={value:d[y]};M.value+=4;let A=Vt(h.viewer,M)-Ut.dataWindow.yMin;h.size=$t(h.viewer,M),h.lines=A+h.blockHeight>h.height?h.height-A:h.blockHeight;let x=h.columns*h.totalBytes,C=h.size<h.lines*x,E=h.offset;h.offset=M;let R=C?h.uncompress(h):Ei(h);h.offset=E;for(let I=0;I<h.lines;I++){let z=A+I,P=I*x,V=(h.height-1-z)*h.outLineWidth;for(let J=0;J<h.inputChannels.length;J++){let H=Ut.channels[J].name,q=h.channelByteOffsets[H]*h.columns,nt=h.decodeChannels[H];if(nt!==void 0){g.value=P+q;for(let at=0;at<h.columns;at++){let st=V+at*h.outputChannels+nt;h.byteArray[st]=h.getter(R,g)}}}}}}function go(h,d,g,y){if(g===0)return null;let M=h.slice(d,d+g);switch(y){case"NO_COMPRESSION":return new DataView(M.buffer,M.byteOffset,M.byteLength);case"RLE_COMPRESSION":{let A=new Uint8Array(Os(M.buffer.slice(M.byteOffset,M.byteOffset+M.byteLength))),x=new Uint8Array(A.length);return bi(A),wi(A,x),new DataView(x.buffer)}case"ZIPS_COMPRESSION":{let A=zn(M),x=new Uint8Array(A.length);return bi(A),wi(A,x),new DataView(x.buffer)}default:throw new Error("THREE.EXRLoader: "+y+" is unsupported for deep data")}}function rc(){let h=this,d=h.chunkOffsets,g=h.width,y=h.height,M=h.deepChannels,A=Ut.compression,x=h.multiPart,C=h.decodeChannels,E=h.outputChannels,R=h.byteArray instanceof Uint16Array,I=-1;for(let z=0;z<M.length;z++)if(M[z].name==="A"){I=z;break}for(let z=0;z<d.length;z++){let P={value:d[z]};x&&(P.value+=4);let V=Vt(h.viewer,P)-Ut.dataWindow.yMin,J=Pt(h.viewer,P),H=Pt(h.viewer,P);Pt(h.viewer,P);let q=go(h.array,P.value,J,A);if(P.value+=J,q===null)continue;let nt=new Uint32Array(g);for(let tt=0;tt<g;tt++)nt[tt]=q.getUint32(tt*4,!0);let at=nt[g-1];if(at===0){P.value+=H;continue}let st=go(h.array,P.value,H,A),ut=[],Q=0;for(let tt=0;tt<M.length;tt++)ut.push(Q),Q+=at*M[tt].bytesPerSample;let K=(y-1-V)*h.outLineWidth;for(let tt=0;tt<g;tt++){let pt=tt===0?0:nt[tt-1],rt=nt[tt]-pt;if(rt===0)continue;let lt=new Float32Array(E),wt=0;for(let gt=0;gt<rt;gt++){let xe=pt+gt,gn=1-wt;if(gn<=0)break;let jn=1;if(I>=0){let ve=M[I].bytesPerSample,en=ut[I]+xe*ve;jn=ve===2?G.fromHalfFloat(st.getUint16(en,!0)):st.getFloat32(en,!0)}for(let ve=0;ve<M.length;ve++){let en=M[ve],Ii=C[en.name];if(Ii===void 0)continue;let Pi=en.bytesPerSample,Li=ut[ve]+xe*Pi,Qn=Pi===2?G.fromHalfFloat(st.getUint16(Li,!0)):st.getFloat32(Li,!0);lt[Ii]+=Qn*gn}wt+=jn*gn}C.A!==void 0&&(lt[C.A]=wt);let qt=K+tt*E;for(let gt=0;gt<E;gt++)h.byteArray[qt+gt]=R?G.toHalfFloat(lt[gt]):lt[gt]}}}function _o(h,d,g){let y={},M=!1;for(;;){let A=Ai(d,g);if(A==="")break;M=!0;let x=Ai(d,g),C=$t(h,g),E=Ql(h,d,g,x,C);E===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${x}'.`):y[A]=E}return M?y:null}function oc(h,d,g){if(h.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let y=h.getUint8(4),M=h.getUint8(5),A={singleTile:!!(M&2),longName:!!(M&4),deepFormat:!!(M&8),multiPart:!!(M&16)};g.value=8;let x=[];if(A.multiPart){for(;;){let C=_o(h,d,g);if(C===null)break;C.version=y,C.spec=A,x.push(C)}if(x.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let C=_o(h,d,g);C.version=y,C.spec=A,x.push(C)}return x}function ac(h,d,g,y,M,A){let x={size:0,viewer:d,array:g,offset:y,width:h.dataWindow.xMax-h.dataWindow.xMin+1,height:h.dataWindow.yMax-h.dataWindow.yMin+1,inputChannels:h.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Jt};switch(h.compression){case"NO_COMPRESSION":x.blockHeight=1,x.uncompress=Ei;break;case"RLE_COMPRESSION":x.blockHeight=1,x.uncompress=Ul;break;case"ZIPS_COMPRESSION":x.blockHeight=1,x.uncompress=Bs;break;case"ZIP_COMPRESSION":x.blockHeight=16,x.uncompress=Bs;break;case"PIZ_COMPRESSION":x.blockHeight=32,x.uncompress=Ol;break;case"PXR24_COMPRESSION":x.blockHeight=16,x.uncompress=Fl;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":x.blockHeight=32,x.uncompress=Bl;break;case"DWAA_COMPRESSION":x.blockHeight=32,x.uncompress=fo;break;case"DWAB_COMPRESSION":x.blockHeight=256,x.uncompress=fo;break;default:throw new Error("THREE.EXRLoader: "+h.compression+" is unsupported")}let C={};for(let P of h.channels)switch(P.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":C[P.name]=!0,x.type=P.pixelType}let E=!1,R=!1;if(C.Y&&C.RY&&C.BY)x.outputChannels=4,x.yCbCr=!0;else if(C.R&&C.G&&C.B)x.outputChannels=4;else if(C.Y)x.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(x.outputChannels){case 4:A==ye?(E=!C.A,x.format=ye,x.colorSpace=Jt,x.outputChannels=4,x.decodeChannels={R:0,G:1,B:2,A:3}):A==hn?(x.format=hn,x.colorSpace=Jt,x.outputChannels=2,x.decodeChannels={R:0,G:1}):A==Cn?(x.format=Cn,x.colorSpace=Jt,x.outputChannels=1,x.decodeChannels={R:0}):R=!0;break;case 1:A==ye?(E=!0,x.format=ye,x.colorSpace=Jt,x.outputChannels=4,x.shouldExpand=!0,x.decodeChannels={Y:0}):A==hn?(x.format=hn,x.colorSpace=Jt,x.outputChannels=2,x.shouldExpand=!0,x.decodeChannels={Y:0}):A==Cn?(x.format=Cn,x.colorSpace=Jt,x.outputChannels=1,x.decodeChannels={Y:0}):R=!0;break;default:R=!0}if(R)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(x.yCbCr&&(x.format=ye,x.outputChannels=4,x.decodeChannels={Y:0,RY:1,BY:2},E=!0),x.type==1)switch(M){case ue:x.getter=Vl;break;case fe:x.getter=Kn;break}else if(x.type==2)switch(M){case ue:x.getter=Dt;break;case fe:x.getter=Hl}else throw new Error("THREE.EXRLoader: unsupported pixelType "+x.type+" for "+h.compression+".");x.columns=x.width;let I=x.width*x.height*x.outputChannels;switch(M){case ue:x.byteArray=new Float32Array(I),E&&x.byteArray.fill(1,0,I);break;case fe:x.byteArray=new Uint16Array(I),E&&x.byteArray.fill(15360,0,I);break;default:console.error("THREE.EXRLoader: unsupported type: ",M);break}let z=0;for(let P of h.channels)x.decodeChannels[P.name]!==void 0&&(x.channelByteOffsets[P.name]=z),z+=P.pixelType*2;if(x.totalBytes=z,x.outLineWidth=x.width*x.outputChannels,h.spec.deepFormat){x.deepChannels=[];let P=0;for(let V of h.channels){let J=V.pixelType===0?4:V.pixelType*2;x.deepChannels.push({name:V.name,pixelType:V.pixelType,bytesPerSample:J}),P+=J}x.deepBytesPerSample=P,x.chunkOffsets=h._chunkOffsets,x.multiPart=h.spec.multiPart,x.decode=rc.bind(x)}else if(h.spec.singleTile){x.blockHeight=h.tiles.ySize,x.blockWidth=h.tiles.xSize;let P=ec(h.tiles,x.width,x.height),V=mo(P,x.width,h.tiles.xSize,h.tiles.roundingMode),J=mo(P,x.height,h.tiles.ySize,h.tiles.roundingMode);x.tileCount=V[0]*J[0];for(let H=0;H<P;H++)for(let q=0;q<J[H];q++)for(let nt=0;nt<V[H];nt++)Pt(d,y);x.decode=nc.bind(x)}else if(h.spec.multiPart)x.blockWidth=x.width,x.chunkOffsets=h._chunkOffsets,x.decode=sc.bind(x);else{x.blockWidth=x.width;let P=Math.ceil(x.height/x.blockHeight);for(let V=0;V<P;V++)Pt(d,y);x.decode=ic.bind(x)}return x}let Ti={value:0},Ri=new DataView(t),lc=new Uint8Array(t),Ci=oc(Ri,t,Ti),xo=Math.max(0,Math.min(this.part,Ci.length-1)),Ut=Ci[xo];if(Ut.spec.multiPart||Ut.spec.deepFormat)for(let h=0;h<Ci.length;h++){let d=Ci[h].chunkCount;if(h===xo){Ut._chunkOffsets=[];for(let g=0;g<d;g++)Ut._chunkOffsets.push(Pt(Ri,Ti))}else for(let g=0;g<d;g++)Pt(Ri,Ti)}let te=ac(Ut,Ri,lc,Ti,this.type,this.outputFormat);if(te.decode(),te.shouldExpand){let h=te.byteArray;if(this.outputFormat==ye)for(let d=0;d<h.length;d+=4)h[d+2]=h[d+1]=h[d];else if(this.outputFormat==hn)for(let d=0;d<h.length;d+=2)h[d+1]=h[d]}if(te.yCbCr){let h=te.byteArray,d=te.width*te.height;if(this.type===fe)for(let g=0;g<d;g++){let y=g*4,M=G.fromHalfFloat(h[y]),A=G.fromHalfFloat(h[y+1]),x=G.fromHalfFloat(h[y+2]),C=(1+A)*M,E=(1+x)*M,R=(M-C*.2126-E*.0722)/.7152;h[y]=G.toHalfFloat(Math.max(0,C)),h[y+1]=G.toHalfFloat(Math.max(0,R)),h[y+2]=G.toHalfFloat(Math.max(0,E))}else for(let g=0;g<d;g++){let y=g*4,M=h[y],A=h[y+1],x=h[y+2],C=(1+A)*M,E=(1+x)*M;h[y]=Math.max(0,C),h[y+1]=Math.max(0,(M-C*.2126-E*.0722)/.7152),h[y+2]=Math.max(0,E)}}return{header:Ut,width:te.width,height:te.height,data:te.byteArray,format:te.format,colorSpace:te.colorSpace,type:this.type,minFilter:ce,magFilter:ce,generateMipmaps:!1,flipY:!1}}setDataType(t){return this.type=t,this}setOutputFormat(t){return this.outputFormat=t,this}setPart(t){return this.part=t,this}};var Ms=class extends cn{constructor(t){super(t),this.type=fe}parse(t){let o=function(O,L){switch(O){case 1:throw new Error("THREE.HDRLoader: Read Error: "+(L||""));case 2:throw new Error("THREE.HDRLoader: Write Error: "+(L||""));case 3:throw new Error("THREE.HDRLoader: Bad File Format: "+(L||""));default:case 4:throw new Error("THREE.HDRLoader: Memory Error: "+(L||""))}},f=function(O,L,k){L=L||1024;let B=O.pos,et=-1,W=0,j="",it=String.fromCharCode.apply(null,new Uint16Array(O.subarray(B,B+128)));for(;0>(et=it.indexOf(`
`))&&W<L&&B<O.byteLength;)j+=it,W+=it.length,B+=128,it=String.fromCharCode.apply(null,new Uint16Array(O.subarray(B,B+128)));return-1<et?(k!==!1&&(O.pos+=W+et+1),j+it.slice(0,et)):!1},p=function(O){let L=/^#\?(\S+)/,k=/^\s*GAMMA\s*=\s*(\d+(\.\d+)?)\s*$/,F=/^\s*EXPOSURE\s*=\s*(\d+(\.\d+)?)\s*$/,B=/^\s*FORMAT=(\S+)\s*$/,et=/^\s*\-Y\s+(\d+)\s+\+X\s+(\d+)\s*$/,W={valid:0,string:"",comments:"",programtype:"RGBE",format:"",gamma:1,exposure:1,width:0,height:0},j,it;for((O.pos>=O.byteLength||!(j=f(O)))&&o(1,"no header found"),(it=j.match(L))||o(3,"bad initial token"),W.valid|=1,W.programtype=it[1],W.string+=j+`
`;j=f(O),j!==!1;){if(W.string+=j+`
`,j.charAt(0)==="#"){W.comments+=j+`
`;continue}if((it=j.match(k))&&(W.gamma=parseFloat(it[1])),(it=j.match(F))&&(W.exposure=parseFloat(it[1])),(it=j.match(B))&&(W.valid|=2,W.format=it[1]),(it=j.match(et))&&(W.valid|=4,W.height=parseInt(it[1],10),W.width=parseInt(it[2],10)),W.valid&2&&W.valid&4)break}return W.valid&2||o(3,"missing format specifier"),W.valid&4||o(3,"missing image size specifier"),W},m=function(O,L,k){let F=L;if(F<8||F>32767||O[0]!==2||O[1]!==2||O[2]&128)return new Uint8Array(O);F!==(O[2]<<8|O[3])&&o(3,"wrong scanline width");let B=new Uint8Array(4*L*k);B.length||o(4,"unable to allocate buffer space");let et=0,W=0,j=4*F,it=new Uint8Array(4),St=new Uint8Array(j),zt=k;for(;zt>0&&W<O.byteLength;){W+4>O.byteLength&&o(1),it[0]=O[W++],it[1]=O[W++],it[2]=O[W++],it[3]=O[W++],(it[0]!=2||it[1]!=2||(it[2]<<8|it[3])!=F)&&o(3,"bad rgbe scanline format");let _t=0,Rt;for(;_t<j&&W<O.byteLength;){Rt=O[W++];let Mt=Rt>128;if(Mt&&(Rt-=128),(Rt===0||_t+Rt>j)&&o(3,"bad scanline data"),Mt){let bt=O[W++];for(let Ht=0;Ht<Rt;Ht++)St[_t++]=bt}else St.set(O.subarray(W,W+Rt),_t),_t+=Rt,W+=Rt}let _e=F;for(let Mt=0;Mt<_e;Mt++){let bt=0;B[et]=St[Mt+bt],bt+=F,B[et+1]=St[Mt+bt],bt+=F,B[et+2]=St[Mt+bt],bt+=F,B[et+3]=St[Mt+bt],et+=4}zt--}return B},_=function(O,L,k,F){let B=O[L+3],et=Math.pow(2,B-128)/255;k[F+0]=O[L+0]*et,k[F+1]=O[L+1]*et,k[F+2]=O[L+2]*et,k[F+3]=1},v=function(O,L,k,F){let B=O[L+3],et=Math.pow(2,B-128)/255;k[F+0]=G.toHalfFloat(Math.min(O[L+0]*et,65504)),k[F+1]=G.toHalfFloat(Math.min(O[L+1]*et,65504)),k[F+2]=G.toHalfFloat(Math.min(O[L+2]*et,65504)),k[F+3]=G.toHalfFloat(1)},b=new Uint8Array(t);b.pos=0;let w=p(b),T=w.width,N=w.height,D=m(b.subarray(b.pos),T,N),U,Y,X;switch(this.type){case ue:X=D.length/4;let O=new Float32Array(X*4);for(let k=0;k<X;k++)_(D,k*4,O,k*4);U=O,Y=ue;break;case fe:X=D.length/4;let L=new Uint16Array(X*4);for(let k=0;k<X;k++)v(D,k*4,L,k*4);U=L,Y=fe;break;default:throw new Error("THREE.HDRLoader: Unsupported type: "+this.type)}return{width:T,height:N,data:U,header:w.string,gamma:w.gamma,exposure:w.exposure,type:Y,colorSpace:Jt,minFilter:ce,magFilter:ce,generateMipmaps:!1,flipY:!0}}setDataType(t){return this.type=t,this}};var pi=class extends Error{constructor(t,e,n){super(`${e?e+": ":""}${n} [${t}]`),this.code=t,this.where=e}};function S(r,t,e){throw new pi(r,t,e)}var yt=class extends Error{};function ya(r,t){let e=/\.exr$/i.test(t);if(!e&&!/\.(hdr|pic)$/i.test(t))throw new yt(`${t}: neither .hdr nor .exr`);let n;try{n=new(e?Ss:Ms)().setDataType(ue).parse(r)}catch(l){throw new yt(`${t}: no image that can be read (${l.message??l})`)}let{data:i,width:s,height:o}=n,a=i.length/(s*o),c=new Float32Array(3*s*o);for(let l=0;l<o;l++){let u=e?o-1-l:l;for(let f=0;f<s;f++)for(let p=0;p<3;p++){let m=i[a*(u*s+f)+Math.min(p,a-1)];c[3*(l*s+f)+p]=Number.isFinite(m)?Math.max(0,m):0}}return{rgb:c,width:s,height:o}}var od=`#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;function Sa(r){let t=r.getContext("webgl2",{alpha:!1,antialias:!1,preserveDrawingBuffer:!0});if(!t)throw new yt("this browser has no WebGL2");if(!t.getExtension("EXT_color_buffer_float"))throw new yt("this device's WebGL2 cannot draw into float textures");return t}var kn=class{constructor(t,e){this.gl=t,this.program=t.createProgram();for(let[n,i]of[[t.VERTEX_SHADER,od],[t.FRAGMENT_SHADER,`#version 300 es
${e}`]]){let s=t.createShader(n);t.shaderSource(s,i),t.compileShader(s),t.attachShader(this.program,s),t.deleteShader(s)}t.linkProgram(this.program),this.places=new Map}check(){let{gl:t,program:e}=this;if(t.getProgramParameter(e,t.LINK_STATUS)||t.isContextLost())return;let n=t.getAttachedShaders(e).map(i=>t.getShaderInfoLog(i));throw new Error(`a shader does not compile: ${[t.getProgramInfoLog(e),...n].join(" ")}`)}_place(t){return this.places.has(t)||this.places.set(t,this.gl.getUniformLocation(this.program,t)),this.places.get(t)}set(t){for(let[e,[n,...i]]of Object.entries(t))this.gl[`uniform${n}`](this._place(e),...i)}textures(t){Object.entries(t).forEach(([e,n],i)=>{this.gl.activeTexture(this.gl.TEXTURE0+i),this.gl.bindTexture(n.target,n.texture),this.gl.uniform1i(this._place(e),i)})}delete(){this.gl.deleteProgram(this.program)}},ad=2048;function Oe(r,t,e,n=ad){let i={4:[[r.RGBA32F,r.RGBA,r.FLOAT],[r.RGBA32UI,r.RGBA_INTEGER,r.UNSIGNED_INT]],1:[null,[r.R8UI,r.RED_INTEGER,r.UNSIGNED_BYTE]]},[s,o,a]=i[e][t instanceof Float32Array?0:1],c=Math.max(1,Math.ceil(t.length/e)),l=Math.ceil(c/n);ld(r,l);let u=new t.constructor(n*l*e);return u.set(t),mi(r,n,l,s,o,a,u)}function ld(r,t){let e=r.getParameter(r.MAX_TEXTURE_SIZE);if(t>e)throw new yt(`the asset needs textures of side ${t}; this device has ${e}`)}function mi(r,t,e,n,i,s,o=null){let a=r.createTexture();return r.bindTexture(r.TEXTURE_2D,a),r.pixelStorei(r.UNPACK_ALIGNMENT,1),r.texImage2D(r.TEXTURE_2D,0,n,t,e,0,i,s,o),$r(r,r.TEXTURE_2D),{target:r.TEXTURE_2D,texture:a,width:t,height:e}}function $r(r,t){r.texParameteri(t,r.TEXTURE_MIN_FILTER,r.NEAREST),r.texParameteri(t,r.TEXTURE_MAG_FILTER,r.NEAREST),r.texParameteri(t,r.TEXTURE_WRAP_S,r.CLAMP_TO_EDGE),r.texParameteri(t,r.TEXTURE_WRAP_T,r.CLAMP_TO_EDGE)}var Je=class{constructor(t,e,n,i){if(Object.assign(this,{gl:t,width:e,height:n}),this.images=Array.from({length:i},()=>mi(t,e,n,t.RGBA32F,t.RGBA,t.FLOAT)),this.frame=t.createFramebuffer(),t.bindFramebuffer(t.FRAMEBUFFER,this.frame),this.images.forEach(({texture:s},o)=>t.framebufferTexture2D(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0+o,t.TEXTURE_2D,s,0)),t.drawBuffers(this.images.map((s,o)=>t.COLOR_ATTACHMENT0+o)),t.checkFramebufferStatus(t.FRAMEBUFFER)!==t.FRAMEBUFFER_COMPLETE&&!t.isContextLost())throw new yt("this device cannot draw into float textures")}read(t){let{gl:e,width:n,height:i}=this,s=new Float32Array(4*n*i);return e.bindFramebuffer(e.FRAMEBUFFER,this.frame),e.readBuffer(e.COLOR_ATTACHMENT0+t),e.readPixels(0,0,n,i,e.RGBA,e.FLOAT,s),s}delete(){this.gl.deleteFramebuffer(this.frame);for(let{texture:t}of this.images)this.gl.deleteTexture(t)}};function fn(r,t,e,{textures:n={},uniforms:i={},from:s=0,to:o}={}){let{width:a,height:c}=e??r.canvas;r.bindFramebuffer(r.FRAMEBUFFER,e?.frame??null),r.viewport(0,0,a,c),r.enable(r.SCISSOR_TEST),r.scissor(0,s,a,(o??c)-s),r.useProgram(t.program),t.set(i),t.textures(n),r.drawArrays(r.TRIANGLES,0,3)}async function Ma(r){let t=r.fenceSync(r.SYNC_GPU_COMMANDS_COMPLETE,0);for(r.flush();;){if(r.isContextLost())return;let e=r.clientWaitSync(t,0,0);if(e===r.ALREADY_SIGNALED||e===r.CONDITION_SATISFIED)break;await new Promise(n=>setTimeout(n,1))}r.deleteSync(t)}var ba=`// Input blocks of a decoder (spec, 6.3), in the forms for float32.

uniform sampler2DArray planes;  // three planes of \`groups\` layers of four channels
uniform int resolution;
uniform int channels;
uniform vec4 scales[48];        // of int8: scale of each channel; else 1
uniform vec3 boundsMin;
uniform vec3 boundsMax;
uniform int blockCount;
uniform int blocks[12];         // in the order of the columns; see BLOCKS

const int FEATURES = 0, POSITION = 1, AXIS = 2, H = 3, WO = 4, WI = 5, HALF_VECTOR = 6, HIGHLIGHT = 7,
          LEARNED_NORMAL = 8, FIBER_ANGLES = 9, FIBER_LOBES = 10;

float columns[COLUMNS];

// Features are summed over the planes (spec, 5).
vec4 featuresOf(int group, vec3 p) {
  int groups = (channels + 3) / 4;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 3; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1) % 3]) * float(resolution) - 0.5, 0.0, float(resolution - 1));
    ivec2 low = ivec2(floor(at)), high = min(low + 1, resolution - 1);
    vec2 f = at - floor(at);
    int layer = k * groups + group;
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    sum += mix(lower, upper, f.y) * scales[layer];
  }
  return sum;
}

vec3 halfway(vec3 wo, vec3 wi, vec3 instead) {
  vec3 s = wi + wo, e = wi - wo;
  float apart = dot(e, e), together = dot(s, s);
  if (together < 1e-12) return instead;
  if (together < apart) s -= e * (dot(s, e) / apart);
  return unit(s);
}

float gap(vec3 n, vec3 m) {
  vec3 d = n - m;
  return log2(0.5 * dot(d, d) + 1e-4) / 6.0;
}

void put(inout int at, float value) {
  columns[at++] = value;
}

void put3(inout int at, vec3 v) {
  put(at, v.x);
  put(at, v.y);
  put(at, v.z);
}

void putFeatures(inout int at, vec3 p) {
  for (int group = 0; 4 * group < channels; group++) {
    vec4 f = featuresOf(group, p);
    for (int c = 0; c < 4 && 4 * group + c < channels; c++) put(at, f[c]);
  }
}

void putFiber(inout int at, int block, vec3 t, float h, vec3 wo, vec3 wi) {
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  if (block == FIBER_ANGLES) {
    put3(at, vec3(si, so, sum));
    put3(at, vec3(log2(sum * sum + 1e-3) / 6.0, cosPhi, sinPhi));
    return;
  }
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  for (int p = 0; p < 3; p++) {
    put(at, cosPhi * lobe.x + sinPhi * lobe.y);
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
}

// Fills \`columns\`. x: a position, axis: n or t; all directions unit.
void fillColumns(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - boundsMin) / (boundsMax - boundsMin), 0.0, 1.0);
  int at = 0;
  for (int k = 0; k < blockCount; k++) {
    int block = blocks[k];
    if (block == FEATURES) putFeatures(at, p);
    else if (block == POSITION) put3(at, 2.0 * p - 1.0);
    else if (block == AXIS) put3(at, axis);
    else if (block == H) put(at, h);
    else if (block == WO) put3(at, wo);
    else if (block == WI) put3(at, wi);
    else if (block == HALF_VECTOR) {
      vec3 m = halfway(wo, wi, axis);
      put3(at, vec3(dot(axis, m), gap(axis, m), dot(axis, wi)));
      put(at, dot(axis, wo));
      put(at, dot(wi, m));
    } else if (block == HIGHLIGHT) {
      vec3 c = cross(axis, halfway(wo, wi, axis));
      put(at, log2(dot(c, c) + 1e-8) / 12.0);
    } else if (block == LEARNED_NORMAL) {
      vec3 f = featuresOf(0, p).xyz * vec3(1.0, float(channels > 1), float(channels > 2));
      vec3 bent = axis + 0.1 * f;
      vec3 q = length(bent) < 1e-6 ? axis : unit(bent), m = halfway(wo, wi, q);
      put(at, dot(q, m));
      put(at, gap(q, m));
    } else putFiber(at, block, axis, h, wo, wi);
  }
}
`;var wa=`// Adds what one light brings, or what the asset emits, to the picture.
precision highp float;
precision highp sampler2D;
uniform sampler2D before;
uniform sampler2D rows0;
uniform sampler2D rows3;
uniform sampler2D lit0;
uniform sampler2D lit1;
uniform sampler2D lit2;
uniform sampler2D first;
uniform sampler2D second;
uniform bool isEmission;
uniform bool countsCoverage;  // once a round
uniform bool isFirst;
uniform bool fromQueries;     // answers are there, of this pass
out vec4 sum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  sum = isFirst ? vec4(0.0) : texelFetch(before, pixel, 0);
  float part = texelFetch(rows0, pixel, 0).w;
  vec3 a = texelFetch(first, pixel, 0).xyz;
  if (isEmission) {
    if (part > 0.0) sum.xyz += texelFetch(rows3, pixel, 0).xyz * a;
    return;
  }
  vec4 light = texelFetch(lit0, pixel, 0), v = texelFetch(lit1, pixel, 0);
  vec3 radiance = texelFetch(lit2, pixel, 0).xyz;
  if (light.w == 1.0) sum.xyz += radiance * mix(texelFetch(second, pixel, 0).xyz, a, v.xyz);
  if (light.w == 2.0) sum.xyz += radiance;
  if (countsCoverage) sum.w += v.w;
}
`;var Ea=`// What the decoder of one part answers for the queries on it.
uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D lit0;
uniform int part;
uniform bool isFiber;
uniform bool hasLight;

layout(location = 0) out vec4 first;   // visible, or emitted
layout(location = 1) out vec4 second;  // shadowed

// By its bits: shaders may assume that there is no NaN.
bool isUsable(vec3 v) {
  uvec3 bits = floatBitsToUint(v) & 0x7f800000u;
  return bits.x != 0x7f800000u && bits.y != 0x7f800000u && bits.z != 0x7f800000u;
}

bool isDirection(vec3 v) {
  uvec3 bits = floatBitsToUint(v) & 0x7fffffffu;
  return isUsable(v) && (bits.x | bits.y | bits.z) != 0u;
}

// Unit to rounding is taken as it is (spec, 6.3); the smallest numbers are brought up first.
vec3 direction(vec3 v) {
  if (abs(dot(v, v) - 1.0) < 5e-7) return v;
  vec3 size = abs(v);
  return unit(max(size.x, max(size.y, size.z)) < 1e-30 ? v * 1e30 : v);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0);
  vec4 light = texelFetch(lit0, pixel, 0);
  if (int(row0.w) != part + 1 || (hasLight && light.w != 1.0)) discard;
  vec4 row1 = texelFetch(rows1, pixel, 0);
  vec3 wo = texelFetch(rows2, pixel, 0).xyz, wi = hasLight ? light.xyz : wo;
  first = vec4(0.0, 0.0, 0.0, 1.0);
  second = vec4(0.0, 0.0, 0.0, 1.0);
  bool usable = isUsable(row0.xyz) && isDirection(row1.xyz) && isDirection(wo) && isDirection(wi)
    && isUsable(row1.www);
  if (!usable) return;
  float h = isFiber ? clamp(row1.w, -1.0, 1.0) : 0.0;
  fillColumns(row0.xyz, direction(row1.xyz), h, direction(wo), direction(wi));
  vec3 a, b;
  decode(COLUMNS, a, b);
  first.xyz = a;
  second.xyz = b;
}
`;var Aa=`// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;
uniform int layerCount;
uniform ivec4 layers[LAYERS];   // groups of inputs, groups of outputs, first texel of weights, of bias
uniform vec2 steps[LAYERS];     // of int8: scale of the inputs; first texel of the outputs' scales
uniform bool isInt8;
uniform int gainAt;             // of int8: first texel of gains, then of offsets
uniform vec3 limits;            // low and high of the first Clip, top of the second
uniform int matrixAt;           // first texel of the matrix, or -1
uniform float unitOf;
uniform int outputs;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(int k) {
  return texelFetch(weights, ivec2(k & 1023, k >> 10), 0);
}

void runLayer(int k) {
  ivec4 layer = layers[k];
  bool last = k == layerCount - 1;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (int i = 0; i < layer.x; i++) values[i] = clamp(roundEven(values[i] / steps[k].x), 0.0, 255.0);
  }
  for (int o = 0; o < layer.y; o++) {
    vec4 sum = isInt8 ? vec4(0.0) : weightAt(layer.w + o);
    int at = layer.z + 4 * layer.x * o;
    for (int i = 0; i < layer.x; i++, at += 4) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1) * x.y + weightAt(at + 2) * x.z + weightAt(at + 3) * x.w;
    }
    if (isInt8) sum = (sum + weightAt(layer.w + o)) * weightAt(int(steps[k].y) + o) * steps[k].x;
    next[o] = last || isInt8 ? sum : max(sum, 0.0);
  }
  for (int o = 0; o < layer.y; o++) values[o] = next[o];
}

// Six numbers of \`columns\`, three and three.
void decode(int width, out vec3 first, out vec3 second) {
  int groups = layers[0].x;
  for (int i = 0; i < groups; i++) {
    vec4 value = vec4(0.0);
    for (int c = 0; c < 4; c++) if (4 * i + c < width) value[c] = columns[4 * i + c];
    value = clamp(value, limits.x, limits.y);
    values[i] = isInt8 ? value * weightAt(gainAt + i) + weightAt(gainAt + groups + i) : value;
  }
  for (int k = 0; k < layerCount; k++) runLayer(k);
  int last = layers[layerCount - 1].y;
  float result[8];
  for (int i = 0; i < 8; i++) result[i] = 0.0;
  for (int i = 0; i < last; i++) values[i] = exp(clamp(values[i], 0.0, limits.z)) - 1.0;
  if (matrixAt < 0) {
    for (int i = 0; i < outputs; i++) result[i] = values[i / 4][i % 4] * unitOf;
  } else {
    for (int i = 0; i < last; i++) {
      for (int c = 0; c < 4; c++) {
        vec4 low = weightAt(matrixAt + 2 * (4 * i + c)), high = weightAt(matrixAt + 2 * (4 * i + c) + 1);
        for (int o = 0; o < 4; o++) {
          result[o] += values[i][c] * low[o];
          result[4 + o] += values[i][c] * high[o];
        }
      }
    }
  }
  first = max(vec3(result[0], result[1], result[2]), 0.0);
  second = max(vec3(result[3], result[4], result[5]), 0.0);
}
`;var Ta=`// A ray from the camera through each pixel, to the query of its first hit.
#include random

uniform vec3 cameraAt;
uniform vec3 corner;       // direction through the image's top left corner
uniform vec3 stepX;        // of a pixel
uniform vec3 stepY;
uniform int height;

layout(location = 0) out vec4 row0;  // x; part + 1, or 0
layout(location = 1) out vec4 row1;  // n or t; of a fiber h, of a surface b1
layout(location = 2) out vec4 row2;  // wo; place of the primitive
layout(location = 3) out vec4 row3;  // throughput; b2

const int LAYERS_SEEN_THROUGH = 32;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 jitter = firstRandom(pixel, 0);
  vec2 at = vec2(pixel.x, height - 1 - pixel.y) + jitter;
  vec3 d = normalize(corner + at.x * stepX + at.y * stepY), origin = cameraAt, through = vec3(1.0);
  row0 = vec4(0.0);
  row1 = vec4(0.0);
  row2 = vec4(-d, 0.0);
  row3 = vec4(0.0);
  for (int k = 0; k < LAYERS_SEEN_THROUGH; k++) {
    Hit hit = nearest(origin, d);
    if (hit.t == FAR) break;
    uvec4 primitive = wordsAt(primitives, hit.place);
    bool fiber = (hit.number & SEGMENT) != 0u;
    vec3 tau = fiber ? vec3(0.0) : transmittance(primitive, hit, d);
    float chance = max(tau.x, max(tau.y, tau.z));
    // Straight on, or stopped here: chosen at random (spec, 4.4).
    if (chance > 0.0 && firstRandom(pixel, 2 + k).x < chance) {
      through *= tau / chance;
      origin += d * (hit.t + 4.0 * epsilon);
      continue;
    }
    if (chance > 0.0) through *= (1.0 - tau) / (1.0 - chance);
    vec3 x = origin + hit.t * d;
    float part = float(partOf(hit.number & ~SEGMENT) + 1);
    if (fiber) {
      vec3 t = tangentOf(primitive);
      row1 = vec4(t, offsetAcross(hit.n, t, -d));
    } else {
      x = mixed(cornersOf(primitive).p, weightsOf(hit));
      row1 = vec4(shadingNormal(primitive, hit), hit.b1);
    }
    row0 = vec4(x, part);
    row2.w = float(hit.place);
    row3.w = hit.b2;
    break;
  }
  row3.xyz = through;
}
`;var Ra=`// Where a ray meets a triangle or a round segment (spec, 4.1 and 4.2).

// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides.
struct Shear {
  ivec3 axes;
  vec3 s;
};

Shear shearOf(vec3 d) {
  vec3 a = abs(d);
  int z = a.x > a.y ? 0 : 1;
  if (a.z > a[z]) z = 2;
  int x = (z + 1) % 3, y = (z + 2) % 3;
  return Shear(ivec3(x, y, z), vec3(d[x], d[y], 1.0) / d[z]);
}

bool meetsTriangle(uvec4 primitive, vec3 origin, Shear shear, float far, inout Hit hit) {
  vec3 v[3];
  for (int k = 0; k < 3; k++) {
    vec3 p = valuesAt(places, int(primitive[k])).xyz - origin;
    vec3 q = vec3(p[shear.axes.x], p[shear.axes.y], p[shear.axes.z]);
    v[k] = vec3(q.xy - shear.s.xy * q.z, q.z);
  }
  float u0 = v[2].x * v[1].y - v[2].y * v[1].x;
  float u1 = v[0].x * v[2].y - v[0].y * v[2].x;
  float u2 = v[1].x * v[0].y - v[1].y * v[0].x;
  if (min(u0, min(u1, u2)) < 0.0 && max(u0, max(u1, u2)) > 0.0) return false;
  float sum = u0 + u1 + u2;
  if (sum == 0.0) return false;
  float t = (u0 * v[0].z + u1 * v[1].z + u2 * v[2].z) * shear.s.z / sum;
  if (!(t >= 0.0 && t < far)) return false;
  hit.t = t;
  hit.number = primitive.w;
  hit.b1 = u1 / sum;
  hit.b2 = u2 / sum;
  return true;
}

struct Cone {
  vec3 a, b;
  float ra, rb;
};

Cone coneAt(int point) {
  vec4 a = valuesAt(places, point), b = valuesAt(places, point + 1);
  return Cone(a.xyz, b.xyz, a.w, b.w);
}

// The entry into a sphere, from a point near it.
float entersSphere(vec3 origin, vec3 d, vec3 centre, float radius) {
  vec3 between = origin - centre;
  float along = dot(between, d);
  vec3 across = between - along * d;
  float h = radius * radius - dot(across, across);
  return h > 0.0 ? -along - sqrt(h) : 1e30;
}

// The first of all points where the line enters one of the two spheres or the side between them.
bool entersCone(Cone cone, vec3 origin, vec3 d, out float t, out vec3 n) {
  vec3 axis = cone.b - cone.a;
  // From the point of the line nearest to the segment, so that distances do not cancel.
  float shift = dot(0.5 * (cone.a + cone.b) - origin, d);
  vec3 near = (origin - cone.a) + shift * d;
  float dr = cone.ra - cone.rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
  float ta = entersSphere(near, d, vec3(0.0), cone.ra), tb = entersSphere(near, d, axis, cone.rb);
  t = min(ta, tb);
  n = near + t * d - (ta < tb ? vec3(0.0) : axis);
  if (d2 > 0.0) {
    float m1 = dot(axis, near), m2 = dot(axis, d), m3 = dot(d, near);
    float k2 = d2 - m2 * m2, k1 = d2 * m3 - m1 * m2 + m2 * dr * cone.ra;
    float k0 = d2 * dot(near, near) - m1 * m1 + 2.0 * m1 * dr * cone.ra - length2 * cone.ra * cone.ra;
    float h = k1 * k1 - k0 * k2;
    if (h >= 0.0 && k2 != 0.0) {
      for (float way = -1.0; way < 2.0; way += 2.0) {
        float side = (-k1 + way * sqrt(h)) / k2, y = m1 - cone.ra * dr + side * m2;
        vec3 normal = d2 * (near + side * d) - axis * y;
        if (y > 0.0 && y < d2 && side < t && dot(normal, d) < 0.0) {
          t = side;
          n = normal;
        }
      }
    }
  }
  if (t > 1e29) return false;
  t += shift;
  n = unit(n);
  return true;
}

// How far p is outside of the cone; negative inside.
float distanceTo(Cone cone, vec3 p) {
  vec3 axis = cone.b - cone.a, near = p - cone.a;
  float dr = cone.ra - cone.rb, size = length(axis), y = dot(near, axis) / size, z = y - size;
  float x = length(near - axis * (y / size));
  float toA = length(vec2(x, y)) - cone.ra, toB = length(vec2(x, z)) - cone.rb;
  if (size * size <= dr * dr) return dr > 0.0 ? toA : toB;
  float slope = dr / size, lean = sqrt(1.0 - slope * slope), along = y * lean - x * slope;
  if (along <= 0.0) return toA;
  if (along >= size * lean) return toB;
  return x * lean + y * slope - cone.ra;
}

// An entry inside the segment before or after is no surface.
bool insideNeighbour(int point, uint neighbours, vec3 p) {
  for (int k = 0; k < 2; k++) {
    if ((neighbours & uint(1 + k)) == 0u) continue;
    Cone cone = coneAt(point + (k == 0 ? -1 : 1));
    if (distanceTo(cone, p) < -1e-4 * min(cone.ra, cone.rb)) return true;
  }
  return false;
}

bool meetsSegment(uvec4 primitive, vec3 origin, vec3 d, float far, inout Hit hit) {
  int point = int(primitive.x);
  float t;
  vec3 n;
  if (!entersCone(coneAt(point), origin, d, t, n)) return false;
  if (!(t >= 0.0 && t < far)) return false;
  if (insideNeighbour(point, primitive.z, origin + t * d)) return false;
  hit.t = t;
  hit.number = primitive.w;
  hit.n = n;
  return true;
}
`;var Ca=`// For each query a direction of one light, what arrives from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // 0: sun, 1: environment, 2: given directions
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D environment;  // radiance, row 0 at +y; w: the row's distribution along it
uniform sampler2D marginal;     // distribution over rows
uniform vec2 turn;              // cosine and sine of the environment's rotation
uniform vec4 ground;            // height, 1 if there is one, middle x and z
uniform vec3 groundColour;      // radiance of it in full light, over the light's irradiance
uniform float groundSize;
uniform vec3 cameraAt;

layout(location = 0) out vec4 lit0;  // wi; 0 nothing, 1 a query, 2 radiance in lit2
layout(location = 1) out vec4 lit1;  // visibility; coverage
layout(location = 2) out vec4 lit2;  // radiance over density, times the throughput

const float PI = 3.14159265358979;

int searched(sampler2D table, int row, int count, float u, int channel) {
  int low = 0, high = count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(table, ivec2(middle, row), 0)[channel] > u) high = middle;
    else low = middle + 1;
  }
  return low;
}

vec3 environmentAt(vec2 st) {
  ivec2 size = textureSize(environment, 0);
  vec2 at = st * vec2(size) - 0.5, low = floor(at), f = at - low;
  ivec2 a = ivec2(low), b = a + 1;
  a.y = clamp(a.y, 0, size.y - 1);
  b.y = clamp(b.y, 0, size.y - 1);
  a.x = (a.x + size.x) % size.x;
  b.x = b.x % size.x;
  return mix(mix(texelFetch(environment, a, 0), texelFetch(environment, ivec2(b.x, a.y), 0), f.x),
             mix(texelFetch(environment, ivec2(a.x, b.y), 0), texelFetch(environment, b, 0), f.x), f.y).xyz;
}

// A direction in proportion to the luminance of texels; radiance over density.
vec3 sampleEnvironment(vec2 u, out vec3 wi) {
  ivec2 size = textureSize(environment, 0);
  int row = searched(marginal, 0, size.y, u.y, 0);
  float before = row > 0 ? texelFetch(marginal, ivec2(row - 1, 0), 0).x : 0.0;
  float chance = texelFetch(marginal, ivec2(row, 0), 0).x - before, v = (u.y - before) / chance;
  int column = searched(environment, row, size.x, u.x, 3);
  float left = column > 0 ? texelFetch(environment, ivec2(column - 1, row), 0).w : 0.0;
  float width = texelFetch(environment, ivec2(column, row), 0).w - left;
  vec2 st = (vec2(column, row) + vec2((u.x - left) / width, clamp(v, 0.0, 1.0))) / vec2(size);
  float theta = PI * st.y, phi = 2.0 * PI * (st.x - 0.5), sine = sin(theta);
  vec3 d = vec3(sine * sin(phi), cos(theta), -sine * cos(phi));
  wi = vec3(turn.x * d.x + turn.y * d.z, d.y, turn.x * d.z - turn.y * d.x);
  float density = chance * width * float(size.x * size.y) / (2.0 * PI * PI * max(sine, 1e-6));
  return environmentAt(st) / density;
}

vec3 sampleLight(ivec2 pixel, out vec3 wi) {
  if (lightKind == 1) return lightColour * sampleEnvironment(firstRandom(pixel, 40), wi);
  wi = lightKind == 0 ? lightDirection : texelFetch(given, pixel, 0).xyz;
  return lightColour;
}

vec3 visibilityOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if ((primitive.w & SEGMENT) != 0u) return passes(row0.xyz, wi, primitive.y);
  Hit hit = Hit(0.0, primitive.w, place, row1.w, b2, vec3(0.0));
  return passes(liftedOrigin(primitive, hit, wi), wi, 0xffffffffu);
}

// The ground shows the shadow, and fades with the distance.
void shadeGround(vec3 d, vec3 radiance, vec3 wi, vec3 through) {
  lit1 = vec4(0.0);
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return;
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  if (fade <= 0.0) return;
  float cosine = max(0.0, wi.y);
  vec3 light = cosine > 0.0 ? passes(x + vec3(0.0, epsilon, 0.0), wi, 0xffffffffu) : vec3(0.0);
  lit0.w = 2.0;
  lit1 = vec4(light, fade);
  lit2 = vec4(through * groundColour * radiance * cosine * light * fade, 0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0), row1 = texelFetch(rows1, pixel, 0);
  vec4 row2 = texelFetch(rows2, pixel, 0), row3 = texelFetch(rows3, pixel, 0);
  vec3 wi, radiance = sampleLight(pixel, wi);
  lit0 = vec4(wi, 0.0);
  lit2 = vec4(0.0);
  if (row0.w == 0.0) {
    shadeGround(-row2.xyz, radiance, wi, row3.xyz);
    return;
  }
  lit0.w = 1.0;
  lit1 = vec4(visibilityOf(row0, row1, row2, row3.w, wi), 1.0);
  lit2 = vec4(row3.xyz * radiance, 0.0);
}
`;var Ia=`// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and its own ray to the light (7.1).

struct Corners {
  vec3 p[3], n[3];
  vec2 uv[3];
};

Corners cornersOf(uvec4 primitive) {
  Corners corners;
  for (int k = 0; k < 3; k++) {
    vec4 place = valuesAt(places, int(primitive[k])), normal = valuesAt(normals, int(primitive[k]));
    corners.p[k] = place.xyz;
    corners.n[k] = normal.xyz;
    corners.uv[k] = vec2(place.w, normal.w);
  }
  return corners;
}

vec3 weightsOf(Hit hit) {
  return vec3(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

vec3 mixed(vec3 v[3], vec3 b) {
  return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

vec3 texelAt(uvec4 size, int offset, ivec2 place) {
  ivec2 wide = ivec2(size.xy);
  ivec2 at = place - wide * ivec2(floor(vec2(place) / vec2(wide)));
  int first = offset + (at.y * wide.x + at.x) * int(size.z);
  vec3 value = vec3(0.0);
  for (int c = 0; c < int(size.z); c++) value[c] = float(wordsAt(texels, first + c).x);
  return value;
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
vec3 lookUp(uvec4 size, int offset, vec2 uv) {
  vec2 place = uv * vec2(size.xy) - 0.5, low = floor(place), f = place - low;
  // Repeat before integers: coordinates may be large.
  low -= vec2(size.xy) * floor(low / vec2(size.xy));
  ivec2 at = ivec2(low);
  vec3 lower = mix(texelAt(size, offset, at), texelAt(size, offset, at + ivec2(1, 0)), f.x);
  vec3 upper = mix(texelAt(size, offset, at + ivec2(0, 1)), texelAt(size, offset, at + ivec2(1, 1)), f.x);
  return mix(lower, upper, f.y);
}

// The record of this kind that the triangle is in, or -1.
int recordOf(uint number, uint kind) {
  for (int k = 0; k < recordCount; k++) {
    uvec4 record = wordsAt(records, 3 * k);
    if (record.x == kind && number >= record.y && number < record.z) return k;
  }
  return -1;
}

float fresnel(float index, float c) {
  float g2 = index * index - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), r = (g - c) / (g + c), s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

vec3 transmittance(uvec4 primitive, Hit hit, vec3 d) {
  int k = recordCount > 0 ? recordOf(primitive.w, 0u) : -1;
  if (k < 0) return vec3(0.0);
  uvec4 record = wordsAt(records, 3 * k), size = wordsAt(records, 3 * k + 1), indices = wordsAt(records, 3 * k + 2);
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  vec2 uv = b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
  vec3 tau = lookUp(size, int(record.w), uv) / 255.0;
  if (size.z == 1u) tau = tau.xxx;
  float cutoff = uintBitsToFloat(size.w), front = uintBitsToFloat(indices.x);
  if (cutoff > 0.0) tau = vec3(tau.x > cutoff ? 1.0 : 0.0);
  if (front > 0.0) {
    vec3 n = unit(mixed(corners.n, b)), ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
    float index = dot(d, ng) < 0.0 ? front : uintBitsToFloat(indices.y);
    tau *= 1.0 - fresnel(index, abs(dot(n, d)));
  }
  return tau;
}

// The normal with relief, 4.5.
vec3 mappedNormal(uint number, Corners corners, vec3 b, vec3 n) {
  int k = recordCount > 0 ? recordOf(number, 1u) : -1;
  if (k < 0) return n;
  vec3 e1 = corners.p[1] - corners.p[0], e2 = corners.p[2] - corners.p[0];
  vec2 a = corners.uv[1] - corners.uv[0], c = corners.uv[2] - corners.uv[0];
  float area = a.x * c.y - c.x * a.y;
  if (area == 0.0) return n;
  vec3 u = (c.y * e1 - a.y * e2) * sign(area), v = (a.x * e2 - c.x * e1) * sign(area);
  vec3 along = u - dot(u, n) * n;
  if (length(along) <= 1e-6 * length(u)) return n;
  vec3 t = unit(along), up = cross(n, t);
  if (dot(up, v) > 0.0) up = -up;
  vec2 uv = b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
  uvec4 record = wordsAt(records, 3 * k), size = wordsAt(records, 3 * k + 1);
  vec2 q = (lookUp(size, int(record.w), uv).xy - 127.0) / 127.0;
  vec3 m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
  return length(m) <= 1e-6 ? n : normalize(m);
}

vec3 shadingNormal(uvec4 primitive, Hit hit) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  return mappedNormal(primitive.w, corners, b, unit(mixed(corners.n, b)));
}

vec3 tangentOf(uvec4 primitive) {
  return unit(valuesAt(places, int(primitive.x) + 1).xyz - valuesAt(places, int(primitive.x)).xyz);
}

// h of 4.2.
float offsetAcross(vec3 n, vec3 t, vec3 wo) {
  vec3 across = cross(t, wo);
  float size = length(across);
  return size > 1e-6 ? clamp(dot(n, across) / size, -1.0, 1.0) : 0.0;
}

// Where the visibility ray of a mesh starts.
vec3 liftedOrigin(uvec4 primitive, Hit hit, vec3 wi) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), x = mixed(corners.p, b), n = unit(mixed(corners.n, b));
  vec3 ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
  float side = dot(ng, wi) < 0.0 ? -1.0 : 1.0;
  if (dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && dot(ng, wi) < 0.1) {
    vec3 lift = vec3(0.0);
    for (int k = 0; k < 3; k++) lift += b[k] * max(0.0, dot(corners.p[k] - x, corners.n[k])) * corners.n[k];
    x += (1.0 - max(0.0, dot(ng, wi)) / 0.1) * lift;
    side = 1.0;
  }
  return x + side * epsilon * ng;
}
`;var Pa=`// Numbers in [0, 1): of each pixel and dimension a start of its own, and from there the additive recurrence
// with the plastic number (Roberts 2018), so that the samples of a pixel are spread evenly.

uniform uint sampleNumber;

uint hashed(uint x) {  // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

vec2 firstRandom(ivec2 pixel, int dimension) {
  uint seed = hashed(uint(pixel.x) + hashed(uint(pixel.y) + hashed(uint(dimension))));
  vec2 start = vec2(seed >> 8u, hashed(seed) >> 8u) / 16777216.0;
  // In whole numbers: floats of later samples would lose digits.
  uvec2 turned = uvec2(3242174889u, 2447445414u) * sampleNumber;
  return fract(start + vec2(turned >> 8u) / 16777216.0);
}
`;var qr=`// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node
uniform usampler2D primitives;  // one a primitive, in the order of the leaves
uniform sampler2D places;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D records;     // three texels a record
uniform usampler2D texels;      // one byte of textures each
uniform int recordCount;
uniform int partCount;
uniform int partFirst[16];      // number of its first primitive
uniform bool partIsFiber[16];
uniform float epsilon;          // the spec's e, 7.1

const uint SEGMENT = 0x80000000u;

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

int partOf(uint number) {
  // Parts stand in the order of their first primitives, but for meshes before strands.
  int found = 0, first = -1;
  for (int k = 0; k < partCount; k++) {
    if (int(number) >= partFirst[k] && partFirst[k] > first) {
      found = k;
      first = partFirst[k];
    }
  }
  return found;
}

struct Hit {
  float t;
  uint number;     // of the primitive, with SEGMENT; in \`place\` its place in the table
  int place;
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
`;var La=`// The picture on the page: mean of the samples, exposure, sRGB.
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform float rounds;
uniform float exposure;  // a factor
uniform vec3 backdrop;   // linear light of the screen
uniform vec2 size;       // of the canvas, pixels
out vec4 colour;

vec4 at(ivec2 place) {
  return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0);
}

void main() {
  vec2 scale = vec2(textureSize(picture, 0)) / size;
  vec2 place = gl_FragCoord.xy * scale - 0.5, low = floor(place), f = place - low;
  ivec2 a = ivec2(low);
  vec4 mean = mix(mix(at(a), at(a + ivec2(1, 0)), f.x), mix(at(a + ivec2(0, 1)), at(a + ivec2(1, 1)), f.x), f.y) / rounds;
  vec3 linear = clamp(mean.xyz * exposure, 0.0, 1.0) + max(0.0, 1.0 - mean.w) * backdrop;
  vec3 encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  colour = vec4(clamp(encoded, 0.0, 1.0), 1.0);
}
`;var Na=`// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48;
const float FAR = 1e30;

float entersBox(vec3 low, vec3 high, vec3 origin, vec3 inverse, float far) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 near3 = min(a, b), far3 = max(a, b);
  float near = max(max(near3.x, near3.y), max(near3.z, 0.0));
  float last = min(min(far3.x, far3.y), min(far3.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  uvec4 first = wordsAt(nodes, 2 * node);
  uvec2 second = wordsAt(nodes, 2 * node + 1).xy;
  vec4 a = uintBitsToFloat(first);
  vec2 b = uintBitsToFloat(second);
  return entersBox(a.xyz, vec3(a.w, b), origin, inverse, far);
}

// The nearest hit; t is FAR where there is none.
Hit nearest(vec3 origin, vec3 d) {
  Hit hit = Hit(FAR, 0u, 0, 0.0, 0.0, vec3(0.0));
  vec3 inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return hit;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        bool met = (primitive.w & SEGMENT) != 0u ? meetsSegment(primitive, origin, d, hit.t, hit)
                                                 : meetsTriangle(primitive, origin, shear, hit.t, hit);
        if (met) hit.place = k;
      }
    } else {
      int left = node + 1, right = node + int(words.z);
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      int nearer = a <= b ? left : right, farther = a <= b ? right : left;
      if (max(a, b) < FAR) stack[top++] = farther;
      if (min(a, b) < FAR) {
        node = nearer;
        continue;
      }
    }
    if (top == 0) return hit;
    node = stack[--top];
  }
}

// The light that passes from origin along d to infinity, strand \`own\` being no obstacle.
vec3 passes(vec3 origin, vec3 d, uint own) {
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        Hit hit;
        if ((primitive.w & SEGMENT) != 0u) {
          if (primitive.y != own && meetsSegment(primitive, origin, d, FAR, hit)) return vec3(0.0);
        } else if (meetsTriangle(primitive, origin, shear, FAR, hit)) {
          light *= transmittance(primitive, hit, d);
          if (light == vec3(0.0)) return light;
        }
      }
    } else {
      int left = node + 1, right = node + int(words.z);
      bool first = boxAt(left, origin, inverse, FAR) < FAR, second = boxAt(right, origin, inverse, FAR) < FAR;
      if (first && second) stack[top++] = right;
      if (first || second) {
        node = first ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}
`;var Da=[qr,Ra,Ia,Na].join(`
`),Ua=r=>r.replace("#include random",Pa),bs={hit:Da+Ua(Ta),light:Da+Ua(Ca),decode:[qr,ba,Aa,Ea].join(`
`),clear:"precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",combine:wa,show:La};var Sd={features:0,position:1,normal:2,tangent:2,h:3,wo:4,wi:5,half_vector:6,highlight:7,learned_normal:8,fiber_angles:9,fiber_lobes:10},be=r=>Math.ceil(r/4);function Oa(r,{values:t,scales:e,resolution:n,channels:i,precision:s}){let o=be(i),a=r.getParameter(r.MAX_TEXTURE_SIZE);if(n>a)throw new yt(`planes of ${n} texels a side; this device has ${a}`);let c=s==="float32",l=r.createTexture();r.bindTexture(r.TEXTURE_2D_ARRAY,l),r.pixelStorei(r.UNPACK_ALIGNMENT,1),r.texStorage3D(r.TEXTURE_2D_ARRAY,1,c?r.RGBA32F:r.RGBA16F,n,n,3*o),$r(r,r.TEXTURE_2D_ARRAY);let u=s==="float16"?r.HALF_FLOAT:r.FLOAT,f=s==="float16"?Uint16Array:Float32Array,p=new f(4*n*n),m=n*n;for(let v=0;v<3*o;v++){let b=Math.floor(v/o),w=4*(v%o),T=Math.min(4,i-w);for(let N=0;N<m;N++){let D=(b*m+N)*i+w;for(let U=0;U<T;U++)p[4*N+U]=t[D+U]}r.texSubImage3D(r.TEXTURE_2D_ARRAY,0,0,0,v,n,n,1,r.RGBA,u,p)}let _=new Float32Array(192).fill(1);for(let v=0;e&&v<3;v++)for(let b=0;b<i;b++)_[4*(v*o+(b>>2))+(b&3)]=e[v*i+b];return{target:r.TEXTURE_2D_ARRAY,texture:l,factors:_}}function Md(r){let t=[],e=[],n=[],i=0,s=p=>(t.push(p),i+=p.length/4,i-p.length/4),o=p=>Float32Array.from({length:4*be(p.length)},(m,_)=>p[_]??0),a=r.int8?s(o(r.gain)):0;r.int8&&s(o(r.offset));for(let{weight:p,bias:m,rows:_,columns:v,step:b,scales:w}of r.layers){let T=new Float32Array(16*be(_)*be(v));for(let U=0;U<_;U++)for(let Y=0;Y<v;Y++)T[4*((Y>>2)*4*be(_)+U)+(Y&3)]=p[U*v+Y];let N=s(T),D=s(o(m));e.push(be(_),be(v),N,D),n.push(b??0,r.int8?s(o(w)):0)}let c=r.matrix?s(bd(r)):-1,l=new Float32Array(4*i),u=0;for(let p of t)l.set(p,u),u+=p.length;let f=Math.max(...r.layers.flatMap(({rows:p,columns:m})=>[be(p),be(m)]));return{values:l,layers:e,steps:n,gainAt:a,matrixAt:c,widest:f}}function bd({matrix:r,outputs:t}){let e=r.length/t,n=new Float32Array(32*be(e));for(let i=0;i<e;i++)for(let s=0;s<t;s++)n[8*i+s]=r[i*t+s];return n}var gi=class{constructor(t,e,n,i,s,o){let a=Md(i);this.weights=Oe(t,a.values,4,1024),this.planes=o;let c={COLUMNS:i.columns,LAYERS:i.layers.length,GROUPS:a.widest},l=Object.entries(c).map(([u,f])=>`#define ${u} ${f}
`).join("");this.program=new kn(t,l+bs.decode),this.uniforms={part:["1i",e],isFiber:["1i",+(n.kind==="fiber")],hasLight:["1i",+(i.outputs===6)],resolution:["1i",n.planes.resolution],channels:["1i",n.planes.channels],scales:["4fv",o.factors],boundsMin:["3fv",n.bounds.min],boundsMax:["3fv",n.bounds.max],blockCount:["1i",s.length],blocks:["1iv",s.map(u=>Sd[u])],layerCount:["1i",i.layers.length],layers:["4iv",a.layers],steps:["2fv",a.steps],isInt8:["1i",Number(i.int8)],gainAt:["1i",a.gainAt],limits:["3f",i.low,i.high,i.top],matrixAt:["1i",a.matrixAt],unitOf:["1f",i.unit],outputs:["1i",i.outputs]}}get textures(){return{planes:this.planes,weights:this.weights}}delete(t){this.program.delete(),t.deleteTexture(this.weights.texture)}};var ws=class r{static label="WebGL2";static async open(t){let e=Sa(t),n=new r;Object.assign(n,{gl:e,canvas:t,parts:[],target:null,lost:!1}),n.programs=Object.fromEntries(["hit","light","clear","combine","show"].map(i=>[i,new kn(e,bs[i])]));for(let i of Object.values(n.programs))i.check();return t.addEventListener("webglcontextlost",i=>{i.preventDefault(),n.lost=!0,n.onlost?.("the WebGL context was lost")}),n}setAsset(t,e){let{gl:n}=this;this._deleteAsset(),this.asset={nodes:Oe(n,t.nodes,4),primitives:Oe(n,t.primitives,4),places:Oe(n,t.places,4),normals:Oe(n,t.normals,4),records:Oe(n,t.records,4),texels:Oe(n,t.texels,1)},this.where=t.where,this.geometry={recordCount:["1i",t.recordCount],partCount:["1i",e.length],partFirst:["1iv",t.parts.map(({first:i})=>i)],epsilon:["1f",t.epsilon]},this.parts=e.map((i,s)=>{let o=Oa(n,i.planes),a=new gi(n,s,i,i.transport,i.inputs,o),c=i.emission&&new gi(n,s,i,i.emission,i.emission.inputs,o);return{planes:o,transport:a,emission:c}});for(let{transport:i,emission:s}of this.parts)i.program.check(),s?.program.check()}get emits(){return this.parts.some(({emission:t})=>t)}setEnvironment({values:t,marginal:e,width:n,height:i}){let{gl:s}=this;for(let o of[this.environment,this.marginal])o&&s.deleteTexture(o.texture);this.environment=mi(s,n,i,s.RGBA32F,s.RGBA,s.FLOAT,t),this.marginal=mi(s,i,1,s.R32F,s.RED,s.FLOAT,e)}resize(t,e){if(this.target?.width===t&&this.target.height===e)return;let{gl:n}=this;this._deleteImages(),this.target={width:t,height:e},this.rows=new Je(n,t,e,4),this.lit=new Je(n,t,e,3),this.answers=new Je(n,t,e,2),this.sums=[new Je(n,t,e,1),new Je(n,t,e,1)]}trace(t,e,n,i){fn(this.gl,this.programs.hit,this.rows,{from:n,to:i,textures:this.asset,uniforms:{...this.geometry,...wd(t,this.target.height),sampleNumber:["1ui",e]}})}light(t,e,n,i,s=null){let[o,a,c,l]=this.rows.images;fn(this.gl,this.programs.light,this.lit,{from:n,to:i,textures:{...this.asset,rows0:o,rows1:a,rows2:c,rows3:l,given:s??o,environment:this.environment??o,marginal:this.marginal??o},uniforms:{...this.geometry,...Ad(t),sampleNumber:["1ui",e]}}),this._decode("transport",n,i)}emission(t,e){fn(this.gl,this.programs.clear,this.answers,{from:t,to:e}),this._decode("emission",t,e)}combine({isEmission:t=!1,countsCoverage:e=!1,isFirst:n=!1}){let[i,,,s]=this.rows.images,[o,a,c]=this.lit.images,[l,u]=this.answers.images,f=p=>["1i",Number(p)];fn(this.gl,this.programs.combine,this.sums[1],{textures:{before:this.sums[0].images[0],rows0:i,rows3:s,lit0:o,lit1:a,lit2:c,first:l,second:u},uniforms:{isEmission:f(t),countsCoverage:f(e),isFirst:f(n)}}),this.sums.reverse()}show({rounds:t,exposure:e,backdrop:n}){let{width:i,height:s}=this.canvas;fn(this.gl,this.programs.show,null,{textures:{picture:this.sums[0].images[0]},uniforms:{rounds:["1f",t],exposure:["1f",e],backdrop:["3fv",n],size:["2f",i,s]}})}done(){return Ma(this.gl)}async picture(){let{width:t,height:e}=this.target,n=this.sums[0].read(0),i=new Float32Array(n.length);for(let s=0;s<e;s++)i.set(n.subarray(4*t*s,4*t*(s+1)),4*t*(e-1-s));return i}_decode(t,e,n){let[i,s,o]=this.rows.images,a=this.lit.images[0];for(let c of this.parts){let l=c[t];l&&fn(this.gl,l.program,this.answers,{from:e,to:n,textures:{...l.textures,rows0:i,rows1:s,rows2:o,lit0:a},uniforms:l.uniforms})}}_deleteAsset(){for(let{texture:t}of Object.values(this.asset??{}))this.gl.deleteTexture(t);for(let{planes:t,transport:e,emission:n}of this.parts)this.gl.deleteTexture(t.texture),e.delete(this.gl),n?.delete(this.gl);this.parts=[]}_deleteImages(){for(let t of[this.rows,this.lit,this.answers,...this.sums??[]])t?.delete();this.target=null}close(){this._deleteAsset(),this._deleteImages();for(let t of Object.values(this.programs))t.delete()}};function wd({position:r,corner:t,stepX:e,stepY:n},i){return{cameraAt:["3fv",r],corner:["3fv",t],stepX:["3fv",e],stepY:["3fv",n],height:["1i",i]}}var Ed={sun:0,environment:1,given:2};function Ad({kind:r,direction:t=[0,1,0],colour:e,angle:n=0,ground:i,cameraAt:s}){return{lightKind:["1i",Ed[r]],lightDirection:["3fv",t],lightColour:["3fv",e],turn:["2f",Math.cos(n),Math.sin(n)],cameraAt:["3fv",s],ground:["4f",i?.height??0,i?1:0,i?.x??0,i?.z??0],groundColour:["3fv",i?.colour??[0,0,0]],groundSize:["1f",i?.size??1]}}var Fa={webgl2:ws};async function Ba(r,t){if(t)return Fa[t].open(r);let e=[];for(let n of Object.values(Fa))try{return await n.open(r)}catch(i){e.push(i.message)}throw new yt(`this browser can show the poster alone: ${e.join("; ")}`)}var Ke=22,dn=46,_i=30,za=64,ka=256,Td=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,Gn="manifest.json",Ga=2**20,vi=r=>new DataView(r.buffer,r.byteOffset,r.byteLength);async function Va(r){let{size:t}=r;t===0&&S("FILE_EMPTY",r.name,"the file has no bytes"),t>2**32-2&&S("FILE_TOO_LARGE",r.name,`${t} bytes`);let{count:e,start:n}=await Rd(r),i=await r.read(n,t-Ke),s=Id(i,e,n,r.name);return Ld(s,n,r.name),new Map(s.map(o=>[o.name,o]))}async function Rd(r){let{size:t,name:e}=r,n=vi(await r.read(0,Math.min(4,t))),s=t>=4&&n.getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";t<Ke&&S(s,e,"shorter than the end record of a ZIP archive");let o=vi(await r.read(t-Ke,t)),a=t===Ke&&o.getUint32(0,!0)===101010256;o.getUint32(0,!0)!==101010256&&await Cd(r,s);let c=p=>o.getUint16(p,!0);[4,6,8,10].some(p=>c(p)===65535)&&S("ZIP_ZIP64",e,"a ZIP64 archive"),(c(4)||c(6))&&S("ZIP_ZIP64",e,"an archive of several disks");let l=c(10),u=o.getUint32(12,!0),f=o.getUint32(16,!0);return l>ka&&S("ZIP_TOO_MANY",e,`${l} entries; at most ${ka}`),(c(8)!==l||c(20)!==0||f+u!==t-Ke)&&S("ZIP_DIRECTORY",e,"the end record does not fit the central directory"),(a||l===0)&&S("ZIP_ORDER",e,`${Gn} is not the first entry`),{count:l,start:f}}async function Cd(r,t){let e=await r.read(Math.max(0,r.size-Ke-65535),r.size),n=vi(e);for(let i=e.length-Ke;i>=0;i--)n.getUint32(i,!0)===101010256&&i+Ke+n.getUint16(i+20,!0)===e.length&&S("ZIP_DIRECTORY",r.name,"the archive has a comment");S(t,r.name,"the file does not end with the end record of a ZIP archive")}function Id(r,t,e,n){let i=vi(r),s=[],o=new Set,a=0;for(let c=0;c<t;c++){(a+dn>r.length||i.getUint32(a,!0)!==33639248)&&S("ZIP_DIRECTORY",n,`the central directory has no header ${c}`);let l=i.getUint16(a+28,!0);(a+dn+l>r.length||i.getUint32(a+30,!0))&&S("ZIP_DIRECTORY",n,`header ${c} of the central directory is malformed`);let u=r.subarray(a+dn,a+dn+l),f=String.fromCharCode(...u);Pd(i,a,f,n),(!Td.test(f)||f.includes(`
`)||l>200)&&S("ZIP_NAME",n,`an entry is called ${JSON.stringify(f.slice(0,80))}`);let p=f.toLowerCase();o.has(p)&&S("ZIP_DUPLICATE",f,"the name is there twice"),o.add(p),s.push({name:f,size:i.getUint32(a+24,!0),crc:i.getUint32(a+16,!0),header:i.getUint32(a+42,!0),central:r.subarray(a,a+dn+l)}),a+=dn+l}a!==r.length&&S("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:c,header:l,size:u}of s)l+_i+c.length+u>e&&S("ZIP_TRUNCATED",c,`${u} bytes reach past the entries`);return s}function Pd(r,t,e,n){let i=c=>r.getUint16(t+c,!0),s=c=>r.getUint32(t+c,!0),o=JSON.stringify(e.slice(0,80));(s(42)===4294967295||s(20)===4294967295||s(24)===4294967295)&&S("ZIP_ZIP64",n,`${o} needs ZIP64`),i(34)&&S("ZIP_ZIP64",n,`${o} is on another disk`),i(8)&1&&S("ZIP_ENCRYPTED",n,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([c,l])=>i(c)!==l)||s(38))&&S("ZIP_HEADER",n,`${o}: a version, flag, time or attribute is not the fixed one`),i(10)&&S("ZIP_COMPRESSED",n,`${o} is compressed`),s(20)!==s(24)&&S("ZIP_SIZE",n,`${o} has two sizes`)}function Ld(r,t,e){let n=[...r].sort((o,a)=>o.header-a.header),i=0;n.forEach((o,a)=>{o.end=a+1<n.length?n[a+1].header:t,o.extra=o.end-o.header-_i-o.name.length-o.size,o.extra<0&&S("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==i&&S("ZIP_GAP",e,`bytes ${i} to ${o.header} are no entry's`),i=o.end});let s=n[0];s.name!==Gn&&S("ZIP_ORDER",e,`${Gn} is not the first entry`),s.size>Ga&&S("MANIFEST_TOO_LARGE",Gn,`${s.size} bytes; at most ${Ga}`)}function Wa(r,t){let e=vi(t),{name:n}=r,i=r.name.length;t.length<r.end-r.header&&S("ZIP_TRUNCATED",n,"the file ends within it"),e.getUint32(0,!0)===67324752&&e.getUint16(26,!0)===i&&Ha(t.subarray(4,26),r.central.subarray(6,28))&&Ha(t.subarray(_i,_i+i),r.central.subarray(dn))||S("ZIP_LOCAL_HEADER",n,"local and central header differ");let o=e.getUint16(28,!0),a=_i+i;Nd(t.subarray(a,a+o),o,n),(r.header+a+o)%za&&S("ZIP_ALIGNMENT",n,`data at byte ${r.header+a+o}, no multiple of ${za}`),o!==r.extra&&S(o>r.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let c=t.subarray(a+o,a+o+r.size);return Dd(c)!==r.crc&&S("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),c}function Nd(r,t,e){if(t===0)return;t>=4&&r.length===t&&r[0]===82&&r[1]===78&&r[2]+256*r[3]===t-4&&r.subarray(4).every(i=>i===0)||S("ZIP_EXTRA",e,"the extra field is not zero padding")}var Ha=(r,t)=>r.length===t.length&&r.every((e,n)=>e===t[n]),xi=Array.from({length:4},()=>new Uint32Array(256));for(let r=0;r<256;r++){let t=r;for(let e=0;e<8;e++)t=t&1?t>>>1^3988292384:t>>>1;xi[0][r]=t>>>0}for(let r=1;r<4;r++)for(let t=0;t<256;t++){let e=xi[r-1][t];xi[r][t]=e>>>8^xi[0][e&255]}function Dd(r){let[t,e,n,i]=xi,s=4294967295,o=0;for(;o+4<=r.length;o+=4)s^=r[o]|r[o+1]<<8|r[o+2]<<16|r[o+3]<<24,s=i[s&255]^n[s>>>8&255]^e[s>>>16&255]^t[s>>>24];for(;o<r.length;o++)s=t[(s^r[o])&255]^s>>>8;return(s^4294967295)>>>0}var Ud=64,Od=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,Fd=/[ \t\n\r]*/y,Bd=/[^"\\\u0000-\u001f]*/y,Xa={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function Hn(r,t,e){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{S(e,t,"no UTF-8")}let i=new Yr(n,t,e);i.space(),n[i.at]!=="{"&&S(e,t,"not a JSON object");let s=i.value(1);return i.space(),i.at!==n.length&&i.bad(),s}var Yr=class{constructor(t,e,n){Object.assign(this,{text:t,where:e,code:n,at:0})}bad(t="malformed JSON"){S(this.code,this.where,`${t} at character ${this.at}`)}match(t){t.lastIndex=this.at;let e=t.exec(this.text);return e&&(this.at=t.lastIndex),e}space(){this.match(Fd)}take(t){return this.text.startsWith(t,this.at)?(this.at+=t.length,!0):!1}value(t){let e=this.text[this.at];if((e==="{"||e==="[")&&t>Ud&&this.bad("nested too deep"),e==="{")return this.object(t);if(e==="[")return this.array(t);if(e==='"')return this.string();for(let[s,o]of[["true",!0],["false",!1],["null",null]])if(this.take(s))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(Od);n||this.bad();let i=Number(n[0]);return Number.isFinite(i)||this.notFinite(),i===0?0:i}notFinite(){S("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(t,e){if(this.at+=1,this.space(),!this.take(t)){do this.space(),e(),this.space();while(this.take(","));this.take(t)||this.bad()}}array(t){let e=[];return this.list("]",()=>e.push(this.value(t+1))),e}object(t){let e=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let i=this.string();e.has(i)&&S("JSON_DUPLICATE_KEY",this.where,`the key "${i}" twice`),this.space(),this.take(":")||this.bad(),this.space(),e.set(i,this.value(t+1))});let n=Object.create(null);for(let[i,s]of e)n[i]=s;return n}string(){let t="";for(this.at+=1;t+=this.match(Bd)[0],!this.take('"');){this.take("\\")||this.bad();let e=this.text[this.at++];if(e==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),t+=String.fromCharCode(parseInt(n[0],16))}else e in Xa?t+=Xa[e]:this.bad()}return t.isWellFormed()||this.bad("half of a surrogate pair"),t}};var $a={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},zd=65536;function Vn(r,t,e,n){let i=t.byteOffset+e;return i%r.BYTES_PER_ELEMENT===0?new r(t.buffer,i,n):new r(t.slice(e,e+n*r.BYTES_PER_ELEMENT).buffer)}function Wn(r,t,e){r.length<8&&S(e,t,"shorter than a header");let n=new DataView(r.buffer,r.byteOffset).getBigUint64(0,!0);(n>zd||Number(n)>r.length-8)&&S(e,t,`a header of ${n} bytes`);let i=8+Number(n);r[8]!==123&&S(e,t,"the header does not start with {");let{__metadata__:s,...o}=Hn(r.subarray(8,i),t,e);return{tensors:o,metadata:s,data:i}}var Ya=r=>r!==null&&typeof r=="object"&&!Array.isArray(r),qa=r=>Number.isSafeInteger(r)&&r>=0;function Xn(r){return Ya(r)&&typeof r.dtype=="string"&&Array.isArray(r.shape)&&r.shape.every(qa)&&Array.isArray(r.data_offsets)&&r.data_offsets.length===2&&r.data_offsets.every(qa)}var $n=r=>r===void 0||Ya(r);function qn(r,{tensors:t,data:e},n,i,s){let o=0,a=n.map(c=>{let{dtype:l,shape:u,data_offsets:[f,p]}=t[c],m=u.reduce((_,v)=>_*v,1);return(f!==o||p-f!==m*$a[l].BYTES_PER_ELEMENT||e+p>r.length)&&S(s,i,`the bytes of ${c} are not where they must be`),o=p,Vn($a[l],r,e+f,m)});return e+o!==r.length&&S(s,i,"bytes behind the last tensor"),a}var Za=2**26,kd=2**25,Gd=2**31,Hd={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},Vd={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Ja(r,t,e){let n=Wn(r,t,"GEOMETRY_CONTAINER"),{tensors:i}=n,s="steps"in i||"scales"in i,o=s?Vd:Hd,a=Object.keys(o);Wd(n,o,a,t),s&&e&&S("VERSION_TOO_OLD",t,"quantised curves in a package for readers of 1.0");let c=Object.fromEntries(a.map(v=>[v,i[v].shape])),l=qn(r,n,a,t,"GEOMETRY_RANGE"),u=Object.fromEntries(a.map((v,b)=>[v,l[b]])),f=c.offsets[0]-1,p=c.radii[0];(!(s?c.origins[0]===f&&c.steps[0]===p-f&&c.scales[0]===2:c.points[0]===p)||f<1)&&S("GEOMETRY_ARRAY",t,"tensors whose shapes do not fit each other"),Xd(u.offsets,p,t);let _=s?$d(u,t):u;return qd(_,t),_}function Wd(r,t,e,n){let{tensors:i}=r,s="GEOMETRY_PROFILE",o=Object.keys(i);(o.length!==e.length||e.some(c=>!o.includes(c)))&&S(s,n,`found ${o.join(", ")||"no tensors"}, expected ${e.join(", ")}`),$n(r.metadata)||S(s,n,"__metadata__ is no object");for(let[c,[l,u]]of Object.entries(t)){let f=i[c];Xn(f)&&l.includes(f.dtype)&&f.shape.length===u&&(u===1||f.shape[1]===3)||S(s,n,`${c} is not ${l.join(" or ")} of ${u} dimensions`)}((i.points??i.radii).shape[0]>Za||i.radii.shape[0]>Za||i.offsets.shape[0]-1>kd)&&S(s,n,"more points or strands than allowed"),r.data%64&&S(s,n,"data does not start at a multiple of 64")}function Xd(r,t,e){let n=r[0]===0&&r.at(-1)===t;for(let i=1;i<r.length&&n;i++)n=r[i]>=r[i-1]+2;n||S("GEOMETRY_STRANDS",e,"the offsets do not part the points into strands")}function $d({scales:r,origins:t,offsets:e,steps:n,radii:i},s){let[o,a]=r;o>0&&Number.isFinite(o)||S("GEOMETRY_STEPS",s,"steps without length"),t.some(u=>!Number.isFinite(u))&&S("GEOMETRY_NOT_FINITE",s,"an origin is not finite"),(!(a>0&&Number.isFinite(a))||i.some(u=>u===0))&&S("GEOMETRY_RADIUS",s,"a radius that is not above 0");let c=new Float32Array(3*i.length),l=0;for(let u=0;u+1<e.length;u++){for(let f=0;f<3;f++){let p=t[3*u+f],m=0;c[3*e[u]+f]=p;for(let _=e[u]+1,v=l;_<e[u+1];_++,v++)m+=n[3*v+f],Math.abs(m)>Gd&&S("GEOMETRY_STEPS",s,`strand ${u} goes too far`),c[3*_+f]=p+o*m}l+=e[u+1]-e[u]-1}return{points:c,radii:Float32Array.from(i,u=>u*a),offsets:e}}function qd({points:r,radii:t,offsets:e},n){(r.some(i=>!Number.isFinite(i))||t.some(i=>!Number.isFinite(i)))&&S("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let i=0;i+1<e.length;i++)for(let s=e[i]+1;s<e[i+1];s++)r[3*s]===r[3*s-3]&&r[3*s+1]===r[3*s-2]&&r[3*s+2]===r[3*s-1]&&S("GEOMETRY_SEGMENT",n,`two equal points in strand ${i}`);t.some(i=>!(i>0))&&S("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var Yd={1:Float32Array,2:Uint8Array,3:Int8Array,6:Int32Array},Zd=64*2**20,Jd=4096,Kd=2**18;function ja(r,t){r.length>Zd&&S("DECODER_TOO_LARGE",t,`${r.length} bytes`);let e=c=>S("DECODER_NOT_ONNX",t,c),n=new Zr(e),i=n.message(r,{1:"one",7:"one",8:"many",20:"many",25:"many"});(!i[7]||!i[1])&&e("no graph, or no IR version"),(i[20].length||i[25].length)&&S("DECODER_NESTED",t,"functions or training information"),jd(i,n,t);let s=n.message(i[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});s[15].length&&S("DECODER_NESTED",t,"sparse tensors"),s[1].length>Jd&&S("DECODER_GRAPH",t,`${s[1].length} nodes`);let o=s[1].map(c=>Qd(n,c,t)),a=new Map;for(let c of s[5]){let l=Qa(n,c,t);a.has(l.name)&&S("DECODER_GRAPH",t,`${l.name} is there twice`),a.set(l.name,l)}return{nodes:o,constants:a,inputs:s[11].map(c=>Ka(n,c)),outputs:s[12].map(c=>Ka(n,c))}}function jd(r,t,e){let n=Number(r[1]);n>=7&&n<=10||S("DECODER_VERSION",e,`IR version ${n}`);let i=r[8].map(a=>t.message(a,{1:"one",2:"one"})),s=i.map(a=>t.text(a[1]));s.some(a=>a!==""&&a!=="ai.onnx")&&S("DECODER_DOMAIN",e,`operators of ${s.join(", ")}`);let o=Number(i[0]?.[2]??0);(i.length!==1||o<13||o>21)&&S("DECODER_VERSION",e,`operator set ${o}`)}function Qd(r,t,e){let n=r.message(t,{1:"many",2:"many",4:"one",5:"many",7:"one"}),i=r.text(n[7]);i!==""&&i!=="ai.onnx"&&S("DECODER_DOMAIN",e,`an operator of ${i}`);let s={};for(let o of n[5]){let{1:a,3:c,5:l,6:u,11:f}=r.message(o,{1:"one",3:"one",5:"one",6:"one",11:"many"});(u||f.length)&&S("DECODER_NESTED",e,"a graph within a node"),l&&Qa(r,l,e),s[r.text(a)]=c===void 0?null:Number(BigInt.asIntN(64,c))}return{operator:r.text(n[4]),inputs:n[1].map(r.text),outputs:n[2].map(r.text),attributes:s}}function Qa(r,t,e){let n=r.message(t,{1:"numbers",2:"one",8:"one",9:"one",13:"many",14:"one"});(n[13].length||n[14])&&S("DECODER_EXTERNAL",e,"data outside the file");let i=n[1].map(Number),s=Number(n[2]??0);(i.length>2||i.some(l=>l>8192)||![1,2,3,6,7,9,10].includes(s))&&S("DECODER_TENSOR",e,`a tensor of type ${s} and shape [${i}]`);let o=i.reduce((l,u)=>l*u,1),a=Yd[s],c=a&&n[9]instanceof Uint8Array&&n[9].length===o*a.BYTES_PER_ELEMENT;return{name:r.text(n[8]),type:s,dims:i,values:c?Vn(a,n[9],0,o):null}}function Ka(r,t){let e=r.message(t,{1:"one",2:"one"}),n=r.message(e[2]??new Uint8Array,{1:"one"}),i=r.message(n[1]??new Uint8Array,{1:"one",2:"one"}),o=r.message(i[2]??new Uint8Array,{1:"many"})[1].map(a=>{let{1:c,2:l}=r.message(a,{1:"one",2:"one"});return l!==void 0&&r.text(l),c===void 0?null:Number(c)});return{name:r.text(e[1]),type:Number(i[1]??0),dims:o}}var Zr=class{constructor(t){this.wrong=t,this.fields=0,this.text=(e=new Uint8Array)=>{if(!(e instanceof Uint8Array))return t("a name that is no text");try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(e)}catch{return t("a name that is no UTF-8")}}}message(t,e){t instanceof Uint8Array||this.wrong("a message that is a number");let n={};for(let[i,s]of Object.entries(e))s!=="one"&&(n[i]=[]);for(let i=0;i<t.length;){++this.fields>Kd&&this.wrong("too many fields");let s,o;[s,i]=this.varint(t,i),[o,i]=this.value(t,i,Number(s&7n)),this.keep(n,Number(s>>3n),o,e)}return n}keep(t,e,n,i){let s=i[e];if(s==="many")t[e].push(n);else if(s==="one")t[e]!==void 0&&this.wrong(`the field ${e} twice`),t[e]=n;else if(s==="numbers"&&n instanceof Uint8Array)for(let o=0,a;o<n.length;)[a,o]=this.varint(n,o),t[e].push(a);else s==="numbers"&&t[e].push(n)}value(t,e,n){if(n===0)return this.varint(t,e);let i={1:8,5:4}[n];return n===2&&([i,e]=this.varint(t,e),i=Number(i)),(i===void 0||e+i>t.length)&&this.wrong("a field that is cut short"),[t.subarray(e,e+i),e+i]}varint(t,e){let n=0n;for(let i=0n;i<70n&&!(e>=t.length);i+=7n){let s=t[e++];if(n|=BigInt(s&127)<<i,s<128)return[BigInt.asUintN(64,n),e]}return this.wrong("a number that is cut short")}};var Fe=1,tp=2,ep=3,np=6;function tl(r,{columns:t,outputs:e,output:n,precision:i},s){let o=ja(r,s);ip(o,t,e,n,s);let a=o.nodes.some(({operator:c})=>/^(De)?[qQ]uantizeLinear$/.test(c));return a!==(i==="int8")&&S("DECODER_PRECISION",s,`arithmetic that is not ${i}`),rp(o,s),new Jr(o,t,e,a,s).decoder()}function ip({inputs:r,outputs:t},e,n,i,s){let o=(a,c,l)=>a.length===1&&a[0].name===c&&a[0].type===Fe&&a[0].dims.length===2&&a[0].dims[0]===null&&a[0].dims[1]===l;o(r,"queries",e)||S("DECODER_INPUT",s,`not one input queries [N, ${e}]`),o(t,i,n)||S("DECODER_OUTPUT",s,`not one output ${i} [N, ${n}]`)}var sp=new Set(`Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp
Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization LeakyRelu Less
LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice
Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu Where Xor`.split(/\s+/));function rp({nodes:r,constants:t},e){let n=r.find(({operator:s})=>!sp.has(s));n&&S("DECODER_OPERATOR",e,`the operator ${n.operator}`);let i=new Set(["queries",...t.keys()]);for(let s of r)(s.inputs.some(o=>o&&!i.has(o))||s.outputs.some(o=>i.has(o)))&&S("DECODER_GRAPH",e,"nodes out of order, or a value made twice"),s.outputs.forEach(o=>i.add(o))}var Jr=class{constructor({nodes:t,constants:e},n,i,s,o){Object.assign(this,{constants:e,columns:n,outputs:i,int8:s,where:o,width:n,at:0,value:"queries"});let a=({operator:c,inputs:l})=>c==="DequantizeLinear"&&e.has(l[0]);this.dequantizers=new Map(t.filter(a).map(c=>[c.outputs[0],c])),this.chain=t.filter(c=>!a(c)),this.readers=new Map;for(let c of t.flatMap(l=>l.inputs))this.readers.set(c,(this.readers.get(c)??0)+1)}outside(t){throw new yt(`${this.where}: this viewer runs decoders of the profile (spec, 6.4) alone: ${t} [DECODER_PROFILE]`)}get operator(){return this.chain[this.at]?.operator}next(t){let e=this.chain[this.at];return(e?.operator!==t||e.inputs[0]!==this.value||e.outputs.length!==1)&&this.outside(`${e?.operator??"nothing"} where ${t} must be`),(this.readers.get(this.value)!==1||Object.keys(e.attributes).length)&&this.outside(`${t} with attributes, or a value that is read twice`),this.at+=1,this.value=e.outputs[0],e.inputs.slice(1)}constant(t,e,n){let i=this.constants.get(t);return(!i?.values||i.type!==e||i.dims.join()!==n.join())&&this.outside(`${t??"nothing"} is not of type ${e} and shape [${n}]`),i.values}take(t,...e){let n=this.next(t);return n.length!==e.length&&this.outside(`${t} of ${n.length+1} operands`),e.map(([i,s],o)=>this.constant(n[o],i,s))}decoder(){let t=[Fe,[]],e=[Fe,[this.columns]],[[n],[i]]=this.take("Clip",t,t),s=this.int8?this.take("Mul",e)[0]:null,o=this.int8?this.take("Add",e)[0]:null,a=this.layers(),[[c],[l]]=this.take("Clip",t,t);this.take("Exp");let[[u]]=this.take("Sub",t);(c!==0||u!==1)&&this.outside(`Clip from ${c}, Sub of ${u}`);let[f]=this.operator==="MatMul"?this.take("MatMul",[Fe,[this.width,this.outputs]]):this.take("Mul",t);(this.operator||this.dequantizers.size)&&this.outside("nodes behind the last one"),f.length===1&&this.width!==this.outputs&&S("DECODER_LOAD",this.where,`${this.width} values for ${this.outputs} outputs`);let p=f.length===1?{unit:f[0],matrix:null}:{unit:1,matrix:f};return{low:n,high:i,gain:s,offset:o,layers:a,top:l,...p,int8:this.int8,columns:this.columns,outputs:this.outputs}}layers(){let t=[];for(;;){let e=this.int8?this.quantized():null;if(t.push(this.gemm(e)),this.operator==="Clip")return t;this.int8||this.take("Relu")}}quantized(){let t=[[Fe,[]],[tp,[]]],[[e],[n]]=this.take("QuantizeLinear",...t),[[i],[s]]=this.take("DequantizeLinear",...t);return(n||s||e!==i)&&this.outside("two scales, or a zero point"),e}gemm(t){let e=this.next("Gemm");e.length!==2&&this.outside(`Gemm of ${e.length+1} operands`);let n=p=>this.constants.get(p)?.dims.at(-1)??0,i=this.width;if(!this.int8){let p=n(e[0]);return this.width=p,{weight:this.fitting(e[0],Fe,i,p),bias:this.constant(e[1],Fe,[p]),rows:i,columns:p}}let[s,o]=this.dequantized(e[0],1),[a,c]=this.dequantized(e[1],0),l=n(s),u=this.constant(o,Fe,[l]);return this.constant(c,Fe,[l]).some((p,m)=>p!==Math.fround(t*u[m]))&&this.outside("a bias with a scale of its own"),this.width=l,{weight:this.fitting(s,ep,i,l),bias:this.constant(a,np,[l]),rows:i,columns:l,step:t,scales:u}}fitting(t,e,n,i){let s=this.constants.get(t)?.dims??[];return s.length===2&&s[0]!==n&&S("DECODER_LOAD",this.where,`weights for ${s[0]} values, of which there are ${n}`),this.constant(t,e,[n,i])}dequantized(t,e){let n=this.dequantizers.get(t);return this.dequantizers.delete(t),(n?.attributes.axis!==e||n.inputs.length!==2||this.readers.get(t)!==1)&&this.outside(`${t} is no DequantizeLinear of constants along axis ${e}`),n.inputs}};async function el(r,{elementSize:t,distance:e,size:n},i){let s=await op(r,n,i),o=Math.floor(n/t),a=new Uint8Array(n);for(let c=0;c<t;c++){let l=c*o;for(let u=0;u<o;u++)a[u*t+c]=s[l+u]}if(a.set(s.subarray(o*t),o*t),e){let c={1:Uint8Array,2:Uint16Array,4:Uint32Array}[t],l=new c(a.buffer,0,o);for(let u=e;u<o;u++)l[u]+=l[u-e]}return a}async function op(r,t,e){let n=new Uint8Array(t),i=0;try{let s=new Blob([r]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:a}=await s.read();if(o)break;if(i+a.length>t)throw s.cancel().catch(()=>{}),new RangeError(`more than ${t} bytes`);n.set(a,i),i+=a.length}}catch(s){S("DEFLATE_STREAM",e,`no whole zlib stream of ${t} bytes (${s.message})`)}return i!==t&&S("DEFLATE_STREAM",e,`inflates to ${i} bytes, expected ${t}`),n}var nl={$schema:"https://json-schema.org/draft/2020-12/schema",title:"RNA 1.1 manifest.json",type:"object",if:{required:["parts"]},then:{$ref:"#/$defs/Manifest"},else:{$ref:"#/$defs/ShortManifest"},$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"What a query costs.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder a query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds a query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Where directions were trained, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},Manifest:{additionalProperties:!1,description:"manifest.json. `write_package` computes `entries` and the versions; leave them out.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","parts","tiers"],title:"Manifest",type:"object"},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Where the asset comes from.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},ShortManifest:{additionalProperties:!1,description:"manifest.json of one part that has nothing new since 1.0.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},tiers:{items:{$ref:"#/$defs/ShortTier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","kind","bounds","geometry","tiers"],title:"ShortManifest",type:"object"},ShortTier:{additionalProperties:!1,description:"A tier of one part, planes and decoder in it.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision","name"],title:"ShortTier",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"What a part emits: a decoder of its own, asked with features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"What one part is evaluated with: planes and a decoder, and a decoder of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}}};var Kr={object:r=>r!==null&&typeof r=="object"&&!Array.isArray(r),array:Array.isArray,string:r=>typeof r=="string",number:r=>typeof r=="number",integer:r=>Number.isSafeInteger(r),boolean:r=>typeof r=="boolean",null:r=>r===null};function Yn(r,t,e=""){new Qr(r).check(r,t,e)}var Qr=class{constructor(t){this.root=t}fits(t,e){try{return this.check(t,e,""),!0}catch{return!1}}check(t,e,n){t.$ref&&this.check(this.root.$defs[t.$ref.split("/").pop()],e,n),t.if&&this.check(this.fits(t.if,e)?t.then:t.else,e,n);let i=s=>S("FIELD_VALUE",n,`found ${jr(e)}, expected ${s}`);t.type&&!Kr[t.type](e)&&i(t.type),"const"in t&&e!==t.const&&i(jr(t.const)),t.enum&&!t.enum.includes(e)&&(t.enum.includes("features")&&S("INPUT_UNKNOWN",n,`no block ${jr(e)}`),i(t.enum.join(", ")));for(let s of[t.anyOf,t.oneOf])s&&!s.some(o=>this.fits(o,e))&&this.check(s.find(o=>Kr[o.type]?.(e))??s[0],e,n);t.not&&this.fits(t.not,e)&&i("another value"),typeof e=="number"&&this.checkNumber(t,e,i),typeof e=="string"&&this.checkString(t,e,i),Array.isArray(e)?this.checkArray(t,e,n,i):Kr.object(e)&&this.checkObject(t,e,n)}checkNumber(t,e,n){e<t.minimum&&n(`at least ${t.minimum}`),e>t.maximum&&n(`at most ${t.maximum}`),e<=t.exclusiveMinimum&&n(`more than ${t.exclusiveMinimum}`),e>=t.exclusiveMaximum&&n(`less than ${t.exclusiveMaximum}`)}checkString(t,e,n){e.length<t.minLength&&n(`${t.minLength} characters or more`),e.length>t.maxLength&&n(`at most ${t.maxLength} characters`),t.pattern&&!new RegExp(t.pattern,"u").test(e)&&n(t.pattern)}checkArray(t,e,n,i){e.length<t.minItems&&i(`${t.minItems} items or more`),e.length>t.maxItems&&i(`at most ${t.maxItems} items`),e.forEach((s,o)=>{let a=t.prefixItems?.[o]??t.items;a&&this.check(a,s,`${n}/${o}`)}),t.uniqueItems&&new Set(e).size!==e.length&&S("INPUT_UNKNOWN",n,"a name twice")}checkObject(t,e,n){let i=Object.keys(e),s=t.properties??{};for(let o of i)t.additionalProperties===!1&&!Object.hasOwn(s,o)&&S("FIELD_UNKNOWN",`${n}/${o}`,"no such member"),t.propertyNames&&this.check({type:"string",...t.propertyNames},o,`${n}/${o}`);for(let o of t.required??[])Object.hasOwn(e,o)||S("FIELD_MISSING",`${n}/${o}`,"missing");for(let o of i){let a=Object.hasOwn(s,o)?s[o]:t.additionalProperties;a&&this.check(a,e[o],`${n}/${o}`)}}};function jr(r){let t=JSON.stringify(r);return t.length>60?`${t.slice(0,57)}...`:t}var to={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},yi=(r,t=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:r,maximum:t}),eo={type:"number",minimum:0,maximum:1},pn=r=>({type:"object",properties:r,required:Object.keys(r),additionalProperties:!1}),sl=2**32-2,rl={RNA_deflate:pn({entries:{type:"object",propertyNames:to,additionalProperties:pn({elementSize:{enum:[1,2,4]},distance:yi(0),size:yi(0,sl),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:pn({image:to,width:yi(1),height:yi(1)}),RNA_standin:pn({parts:{type:"array",minItems:1,maxItems:16,items:pn({baseColor:{type:"array",items:eo,minItems:3,maxItems:3},roughness:eo,metallic:eo})}}),RNA_proxy:pn({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:pn({geometry:to,height:yi(1)})}]}}})},Es=Object.keys(rl);function ol(r){let t=r.extensions??{};for(let e of Es){let n=`/extensions/${e}`;if(!Object.hasOwn(t,e)){r.extensionsUsed?.includes(e)&&S("FIELD_MISSING",n,"its data is missing");continue}Yn(rl[e],t[e],n),lp[e](t[e],r,n)}}function no(r,t,e){Object.hasOwn(r.entries,t)||S("REFERENCE_MISSING",e,`no entry ${t}`)}function il(r,t,e){r.length!==t.parts.length&&S("PARTS_DIFFER",e,`found ${r.length} parts, expected ${t.parts.length}`)}var lp={RNA_deflate({entries:r},t,e){t.extensionsRequired?.includes("RNA_deflate")||S("EXTENSION_UNDECLARED",e,"RNA_deflate is not in extensionsRequired");let n=Object.values(r).reduce((i,{size:s})=>i+s,0);n>sl&&S("FIELD_VALUE",e,`${n} decoded bytes`);for(let i of Object.keys(r))no(t,i,e)},RNA_poster({image:r},t,e){no(t,r,e)},RNA_standin({parts:r},t,e){il(r,t,e)},RNA_proxy({parts:r},t,e){il(r,t,e),r.some(n=>n)||S("FIELD_VALUE",e,"a proxy of no part"),r.forEach((n,i)=>{let{transmittance:s,normalMaps:o}=t.parts[i];n&&(s||o)&&S("FIELD_VALUE",e,"a proxy of a part with textures"),(n??[]).forEach(({geometry:a,height:c},l)=>{no(t,a,e),l&&c>=n[l-1].height&&S("FIELD_VALUE",e,"heights must descend")})})}};var al=[1,1],cp=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/,hp=["normal","half_vector","highlight","learned_normal"],up=["tangent","h","fiber_angles","fiber_lobes"],fp=["features","position","normal","tangent","h","wo"];function ll(r){let t=Hn(r,"manifest.json","MANIFEST_NOT_JSON");dp(t),Yn(pp(nl,t),t);let e=mp(t);gp(e),_p(e),xp(e);let n=hl(cl(e.minReaderVersion),al)<0;t.parts&&n&&S("VERSION_TOO_OLD","/minReaderVersion","1.0, with `parts`"),vp(e),ol(e),yp(e),Sp(e),bp(e);let i=(e.extensionsUsed??[]).filter(s=>!Es.includes(s));return{...e,old:n,warnings:i.map(s=>`unknown extension ${s}`)}}var cl=r=>r.split(".").map(Number),hl=(r,t)=>r[0]-t[0]||r[1]-t[1];function dp(r){"format"in r||S("FIELD_MISSING","/format","missing"),r.format!=="rna"&&S("FORMAT_UNKNOWN","/format","this is no RNA package");let t=r.minReaderVersion;typeof t=="string"&&cp.test(t)&&!t.endsWith(`
`)&&hl(cl(t),al)>0&&S("VERSION_TOO_NEW","/minReaderVersion",`the package needs a reader of version ${t}`);let e=Array.isArray(r.parts)?r.parts:[r];for(let n of e)n?.kind!==void 0&&!["surface","fiber"].includes(n.kind)&&S("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(n.kind)}, expected surface or fiber`);for(let n of Array.isArray(r.extensionsRequired)?r.extensionsRequired:[])typeof n=="string"&&!Es.includes(n)&&S("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${n}`)}function pp(r,t){let e="parts"in t?"Manifest":"ShortManifest";return{...r.$defs[e],$defs:r.$defs}}function mp(r){if(r.parts)return r;let{kind:t,bounds:e,geometry:n,...i}=r,s=r.tiers.map(({name:o,validation:a,cost:c,...l})=>({name:o,validation:a,cost:c,parts:[l]}));return{...i,parts:[{name:"asset",kind:t,bounds:e,geometry:n}],tiers:s}}function gp(r){r.parts.forEach(({bounds:{min:t,max:e}},n)=>{t.forEach((i,s)=>{Math.fround(e[s])-Math.fround(i)>=1e-18||S("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${s}`)})});for(let t of["wo","wi"]){let e=r.domain[t];for(let{axis:n}of Array.isArray(e)?e:[])Math.abs(Math.hypot(...n)-1)>.001&&S("FIELD_VALUE",`/domain/${t}`,"an axis is no unit vector")}}function _p(r){for(let[t,e]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=r[t].map(({name:i})=>i);new Set(n).size!==n.length&&S(e,`/${t}`,"a name is there twice")}r.tiers.forEach(({validation:t},e)=>{(t?.flipAtHeight??[]).forEach(({height:n},i,s)=>{i&&n>=s[i-1].height&&S("FIELD_VALUE",`/tiers/${e}/validation/flipAtHeight/${i}`,"heights must descend")})})}function xp(r){r.tiers.forEach((t,e)=>{t.parts.length!==r.parts.length&&S("PARTS_DIFFER",`/tiers/${e}/parts`,`found ${t.parts.length}, expected ${r.parts.length}`),t.parts.forEach((n,i)=>{!n.emission!=!r.tiers[0].parts[i].emission&&S("PARTS_DIFFER",`/tiers/${e}/parts/${i}`,"emission in some tiers alone")})})}function vp(r){let t=r.extensionsUsed??[];for(let e of[...Object.keys(r.extensions??{}),...r.extensionsRequired??[]])t.includes(e)||S("EXTENSION_UNDECLARED","/extensionsUsed",`${e} is not there`)}function yp(r){r.tiers.forEach((t,e)=>t.parts.forEach((n,i)=>{let s=r.parts[i].kind==="surface"?up:hp,o=(a,c)=>{for(let l of a)c(l)||S("INPUT_KIND",`/tiers/${e}/parts/${i}/inputs`,`${l} is not for this part`)};o(n.inputs,a=>!s.includes(a)),o(n.emission?.inputs??[],a=>!s.includes(a)&&fp.includes(a))}))}function Sp(r){r.parts.forEach((t,e)=>{for(let[n,i]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let s=`/parts/${e}/${n}`;t[n]&&t.kind!=="surface"&&S("FIELD_VALUE",s,`of a ${t.kind}`);let o=0;(t[n]??[]).forEach(({triangles:[a,c]},l)=>{a<o&&S(i,`${s}/${l}`,"ranges must ascend and not overlap"),o=a+c})}})}function*Mp(r){for(let[t,e]of r.parts.entries()){yield[`/parts/${t}/geometry`,e.geometry];for(let n of["transmittance","normalMaps"])for(let[i,s]of(e[n]??[]).entries())yield[`/parts/${t}/${n}/${i}`,s.texture]}for(let[t,e]of r.tiers.entries())for(let[n,i]of e.parts.entries()){let s=`/tiers/${t}/parts/${n}`;yield[`${s}/planes`,i.planes],yield[`${s}/decoder`,i.decoder],i.emission&&(yield[`${s}/emission/decoder`,i.emission.decoder])}}function bp(r){let t=new Set;for(let[n,i]of Mp(r))Object.hasOwn(r.entries,i)||S("REFERENCE_MISSING",n,`no entry ${i}`),t.add(i);let e=(r.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(r.entries))!t.has(n)&&!e.some(i=>n.startsWith(i))&&S("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function ul(r,t){for(let e of t.keys())e!=="manifest.json"&&!Object.hasOwn(r.entries,e)&&S("ENTRY_UNDECLARED","/entries",`the archive holds ${e}`);for(let[e,{size:n}]of Object.entries(r.entries)){let i=t.get(e);(!i||e==="manifest.json")&&S("ENTRY_MISSING","/entries",`the archive lacks ${e}`),i.size!==n&&S("ENTRY_SIZE",`/entries/${e}`,`found ${i.size}, expected ${n}`)}}var je={type:"string"},fl={type:"array",items:{type:"number"}},we=r=>({type:"integer",minimum:r,maximum:2**32-1}),Qe=r=>({type:"array",minItems:1,maxItems:1,items:r}),Ee=(r,t={})=>({type:"object",properties:{...r,...t},required:Object.keys(r),additionalProperties:!1}),dl={type:"array",minItems:3,maxItems:3,items:{type:"number"}},pl={const:"KHR_mesh_quantization"};function ml(r){let t=r?[5122,5123,5125,5126]:[5125,5126],e=Ee({bufferView:we(0),componentType:{enum:t},count:we(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:we(0),normalized:r?{type:"boolean"}:{const:!1},min:fl,max:fl,name:je}),n=Ee({buffer:{const:0},byteLength:we(1)},{byteOffset:we(0),target:{enum:[34962,34963]},name:je,...r&&{byteStride:{enum:[4,8]}}}),i=Ee({POSITION:we(0),NORMAL:we(0)},{TEXCOORD_0:we(0)}),s=Ee({attributes:i,indices:we(0)},{mode:{const:4}});return Ee({asset:Ee({version:{const:"2.0"}},{generator:je,copyright:je}),scenes:Qe(Ee({nodes:Qe({const:0})},{name:je})),nodes:Qe(Ee({mesh:{const:0},...r&&{translation:dl,scale:dl}},{name:je})),meshes:Qe(Ee({primitives:Qe(s)},{name:je})),buffers:Qe(Ee({byteLength:we(1)},{name:je})),accessors:{type:"array",minItems:3,maxItems:4,items:e},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...r&&{extensionsUsed:Qe(pl),extensionsRequired:Qe(pl)}},{scene:{const:0},extras:{}})}var wp=ml(!1),Ep=ml(!0);function gl(r,t){let e="extensionsUsed"in r||"extensionsRequired"in r;try{Yn(e?Ep:wp,r)}catch(n){S("GEOMETRY_PROFILE",t,`${n.where}: not as meshes of packages are`)}return e&&Ap(r.nodes[0],t),Tp(r,e,t),e}function Ap({scale:[r,t,e]},n){r>0&&r===t&&r===e||S("GEOMETRY_PROFILE",n,`the scale ${[r,t,e]}`)}function Tp(r,t,e){let{attributes:n,indices:i}=r.meshes[0].primitives[0],s=t?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[a,c]of[...Object.entries(n),["indices",i]]){let l=r.accessors[c],u=l&&r.bufferViews[l.bufferView];if(!u)continue;let[f,p]=s[a];f.includes(l.type)&&p.some(([_,v,b])=>l.componentType===_&&(l.normalized??!1)===v&&u.byteStride===b)||S("GEOMETRY_PROFILE",e,`the accessor of ${a}`)}r.accessors[i]?.componentType===5123&&r.accessors[n.POSITION]?.count>=65535&&S("GEOMETRY_PROFILE",e,"indices of 16 bits for too many vertices")}var Rp={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},Cp={SCALAR:1,VEC2:2,VEC3:3};function _l(r,t,e){let{json:n,bin:i}=Ip(r,t),s=gl(n,t);s&&e&&S("VERSION_TOO_OLD",t,"a quantised mesh in a package for readers of 1.0");let o=n.buffers[0].byteLength;(o>i.length||i.length-o>3)&&S("GEOMETRY_RANGE",t,`a buffer of ${o} bytes in a chunk of ${i.length}`);let a=n.meshes[0].primitives[0],c=f=>Pp(n,i.subarray(0,o),f,t),l={positions:c(a.attributes.POSITION),normals:c(a.attributes.NORMAL),uvs:"TEXCOORD_0"in a.attributes?c(a.attributes.TEXCOORD_0):null,indices:c(a.indices)};Lp(l,t),Np(n.accessors[a.attributes.POSITION],l.positions,s,t);let u=s?Dp(l,n.nodes[0]):l;return u.indices=Uint32Array.from(l.indices),Up(u,t),u}function Ip(r,t){let e="GEOMETRY_CONTAINER",n=new DataView(r.buffer,r.byteOffset,r.length);(r.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&S(e,t,"no binary glTF 2.0"),n.getUint32(8,!0)!==r.length&&S(e,t,"the length in the header is not that of the entry");let i=[];for(let s=12;s<r.length;){s+8>r.length&&S(e,t,"a chunk is cut short");let o=n.getUint32(s,!0),a=n.getUint32(s+4,!0);(o%4||s+8+o>r.length)&&S(e,t,`a chunk of ${o} bytes`),i.push([a,r.subarray(s+8,s+8+o)]),s+=8+o}return i.map(([s])=>s).join()!==[1313821514,5130562].join()&&S(e,t,"not the chunks JSON and BIN"),i[0][1].length>65536&&S(e,t,"JSON of more than 64 KiB"),{json:Hn(i[0][1],t,e),bin:i[1][1]}}function Pp(r,t,e,n){let i=r.accessors[e];i||S("GEOMETRY_RANGE",n,`no accessor ${e}`);let s=r.bufferViews[i.bufferView];s||S("GEOMETRY_RANGE",n,`no buffer view ${i.bufferView}`);let o=Rp[i.componentType],a=Cp[i.type],c=o.BYTES_PER_ELEMENT*a,l=s.byteStride??c,u=(s.byteOffset??0)+(i.byteOffset??0),f=(i.byteOffset??0)+l*(i.count-1)+c;(f>s.byteLength||(s.byteOffset??0)+s.byteLength>t.length)&&S("GEOMETRY_RANGE",n,`accessor ${e} reaches past its bytes`),u%4&&S("GEOMETRY_PROFILE",n,`accessor ${e} is not aligned`);let p=l===c?Vn(o,t,u,a*i.count):new o(a*i.count);if(l!==c){let m=Vn(o,t,u,Math.floor(f-(i.byteOffset??0))/o.BYTES_PER_ELEMENT),_=l/o.BYTES_PER_ELEMENT;for(let v=0;v<i.count;v++)for(let b=0;b<a;b++)p[a*v+b]=m[_*v+b]}return Object.assign(p,{items:a})}function Lp({positions:r,normals:t,uvs:e,indices:n},i){let s=r.length/3;(t.length!==r.length||e&&e.length!==2*s||!s)&&S("GEOMETRY_ARRAY",i,"attributes of different counts"),(n.length%3||!n.length)&&S("GEOMETRY_ARRAY",i,"part of a triangle")}function Np(r,t,e,n){["min","max"].every(s=>{if(r[s]?.length!==3)return!1;for(let o=0;o<3;o++){let a=t[o];for(let l=o;l<t.length;l+=3)(s==="min"?t[l]<a:t[l]>a)&&(a=t[l]);if((e?r[s][o]:Math.fround(r[s][o]))!==a&&Number.isFinite(a))return!1}return!0})||S("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function Dp({positions:r,normals:t,uvs:e},{translation:n,scale:i}){return{positions:Float32Array.from(r,(s,o)=>n[o%3]+i[0]*s),normals:Float32Array.from(t,s=>Math.max(s/32767,-1)),uvs:e&&(e instanceof Uint16Array?Float32Array.from(e,s=>s/65535):e)}}function Up({positions:r,normals:t,uvs:e,indices:n},i){for(let o of[r,t,e??[]])for(let a=0;a<o.length;a++)Number.isFinite(o[a])||S("GEOMETRY_NOT_FINITE",i,"an attribute is not finite");let s=r.length/3;for(let o=0;o<n.length;o++)n[o]>=s&&S("GEOMETRY_INDEX",i,`vertex ${n[o]} of ${s}`);for(let o=0;o<t.length;o+=3){let a=Math.hypot(t[o],t[o+1],t[o+2]);Math.abs(a-1)>.001&&S("GEOMETRY_NORMAL",i,`a normal of length ${a}`)}}var Op={float16:"F16",float32:"F32",int8:"I8"},io=1e18;function xl(r,{planePrecision:t,resolution:e,channels:n},i){let s=Wn(r,i,"PLANES_HEADER"),{tensors:o}=s,a=t==="int8",c=a?{scales:["F32",[3,n]],planes:["I8",[3,e,e,n]]}:{planes:[Op[t],[3,e,e,n]]},l=Object.keys(c),u=Object.keys(o);$n(s.metadata)||S("PLANES_TENSOR",i,"__metadata__ is no object"),(u.length!==l.length||l.some(_=>!u.includes(_)))&&S("PLANES_TENSOR",i,`found ${u.join(", ")||"no tensors"}, expected ${l.join(", ")}`);for(let _ of l)Xn(o[_])||S("PLANES_HEADER",i,`${_} is no tensor`);for(let _ of l){let[v,b]=c[_],w=o[_];w.dtype!==v&&S("PLANES_DTYPE",i,`${_}: found ${w.dtype}, expected ${v}`),w.shape.join()!==b.join()&&S("PLANES_SHAPE",i,`${_}: found [${w.shape}], expected [${b}]`)}let f=qn(r,s,l,i,"PLANES_HEADER");s.data%64&&S("PLANES_ALIGNMENT",i,"data does not start at a multiple of 64");let p=f.at(-1),m=a?f[0]:null;return Fp(t,p,m,i),{values:p,scales:m,resolution:e,channels:n,precision:t}}function Fp(r,t,e,n){let i=()=>S("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${io}`);if(r==="int8")e.some(s=>!(Math.abs(s)*128<=io))&&i();else if(r==="float16")for(let s=0;s<t.length;s++)(t[s]&31744)===31744&&i();else for(let s=0;s<t.length;s++)Math.abs(t[s])<=io||i()}var Bp=8192;function vl(r,t,e,n,i){let s=Wn(r,n,i),o=s.tensors[t];$n(s.metadata)||S(i,n,"__metadata__ is no object"),(Object.keys(s.tensors).join()!==t||!Xn(o))&&S(i,n,`not one tensor ${t}`);let[a,c,l]=o.shape,u=o.shape.length===3&&[a,c].every(p=>p>=1&&p<=Bp);(o.dtype!=="U8"||!u||!e.includes(l))&&S(i,n,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${e.join(" or ")}]`),s.data%64&&S(i,n,"data does not start at a multiple of 64");let[f]=qn(r,s,[t],n,i);return{values:f,height:a,width:c,channels:l}}function yl(r,t,e){let n="TRANSMITTANCE_TEXTURE",i=vl(r,"transmittance",[1,3],e,n);return t.cutoff!==void 0&&i.channels!==1&&S(n,e,"a cutoff of a coloured texture"),i}function Sl(r,t){return vl(r,"normals",[2],t,"NORMAL_MAP_TEXTURE")}function so({triangles:[r,t]},e,n,i,s){r+t>n.indices.length/3&&S(`${s}_RANGE`,i,`triangles ${r} to ${r+t} of ${n.indices.length/3}`),(s==="NORMAL_MAP"||e.width*e.height>1)&&!n.uvs&&S(`${s}_UV`,i,"the mesh has no texture coordinates")}var zp=65536,kp={position:3,normal:3,tangent:3,h:1,wo:3,wi:3,half_vector:5,highlight:1,learned_normal:2,fiber_angles:6,fiber_lobes:3},As=class r{static async open(t){let e=new r;return e.source=t,e.directory=await Va(t),e.cache=new Map,e.manifest=ll(await e._stored(Gn)),ul(e.manifest,e.directory),e}get poster(){return this.manifest.extensions?.RNA_poster}tier(t){let e=t?this.manifest.tiers.find(n=>n.name===t):this.manifest.tiers[0];if(!e){let n=this.manifest.tiers.map(i=>i.name).join(", ");S("TIER_UNKNOWN",this.source.name,`no tier ${t}; there are ${n}`)}return e}bytesOf(t){return this._ranges(this._entriesOf(this.tier(t))).reduce((e,[n,i])=>e+i-n,0)}async load(t){let e=this.tier(t),n=this._entriesOf(e);await this._fetch(n);let i=new Map;for(let o of n)i.set(o,await this._data(o));let s=this.manifest.parts.map((o,a)=>this._part(o,e.parts[a],a,i));return{name:e.name,tier:e,parts:s}}async posterImage(){return this.poster?(await this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(t,e,n,i){let{kind:s,bounds:o,geometry:a}=t,c=this.manifest.old,l=`/parts/${n}`,u=i.get(a),f={name:t.name,kind:s,bounds:Gp(o),inputs:e.inputs};return s==="surface"?f.mesh=_l(u,a,c):f.curves=Ja(u,a,c),f.transmittance=(t.transmittance??[]).map(p=>{let m=yl(i.get(p.texture),p,p.texture);return so(p,m,f.mesh,l,"TRANSMITTANCE"),{...p,texture:m}}),f.normalMaps=(t.normalMaps??[]).map(p=>{let m=Sl(i.get(p.texture),p.texture);return so(p,m,f.mesh,l,"NORMAL_MAP"),{...p,texture:m}}),f.planes=xl(i.get(e.planes),e,e.planes),f.transport=Ml(i,e,e,"transport",6),f.emission=e.emission?{inputs:e.emission.inputs,...Ml(i,e,e.emission,"emission",3)}:null,f}_entriesOf(t){let e=[];for(let n of this.manifest.parts){e.push(n.geometry);for(let i of[...n.transmittance??[],...n.normalMaps??[]])e.push(i.texture)}for(let n of t.parts)e.push(n.planes,n.decoder),n.emission&&e.push(n.emission.decoder);return[...new Set(e)]}_ranges(t){let e=t.map(i=>this.directory.get(i)).sort((i,s)=>i.header-s.header),n=[];for(let{header:i,end:s}of e){let o=n.at(-1);o&&i-o[1]<=zp?o[1]=s:n.push([i,s])}return n}async _fetch(t){let e=t.filter(n=>!this.cache.has(n));this.source.expected=this.source.ranged?this.source.fetched+this._ranges(e).reduce((n,[i,s])=>n+s-i,0):this.source.size;for(let[n,i]of this._ranges(e)){let s=await this.source.read(n,i);for(let o of e){let a=this.directory.get(o);a.header>=n&&a.end<=i&&this.cache.set(o,s.subarray(a.header-n,a.end-n))}}}async _stored(t){let e=this.directory.get(t),n=this.cache.get(t)??await this.source.read(e.header,e.end);return Wa(e,n)}async _data(t){let e=await this._stored(t);await bl(e,this.manifest.entries[t].sha256,t);let n=this.manifest.extensions?.RNA_deflate?.entries[t];if(!n)return e;let i=await el(e,n,t);return await bl(i,n.sha256,t),i}};function Ml(r,t,e,n,i){let o={columns:e.inputs.reduce((a,c)=>a+(kp[c]??t.channels),0),outputs:i,output:n,precision:e.decoderPrecision};return tl(r.get(e.decoder),o,e.decoder)}function Gp({min:r,max:t}){return{min:r.map(Math.fround),max:t.map(Math.fround)}}async function bl(r,t,e){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",r))].map(s=>s.toString(16).padStart(2,"0")).join("")!==t&&S("ENTRY_HASH",e,"the bytes do not have the declared SHA-256")}var wl=65536,Ts=class{constructor(t,e){this.blob=t,this.name=e,this.size=t.size,this.ranged=!1,this.fetched=t.size}async read(t,e){return new Uint8Array(await this.blob.slice(t,e).arrayBuffer())}},Rs=class r{static async open(t,e=()=>{},n){let i=new r;Object.assign(i,{url:t,progress:e,signal:n,fetched:0,name:Hp(t)});let s=await i._ask({Range:`bytes=0-${wl-1}`}),o=/\/(\d+)$/.exec(s.headers.get("Content-Range")??"");i.ranged=s.status===206&&o!==null;let a=Number(s.headers.get("Content-Length"))||0;return i.expected=i.ranged?wl:a,i.head=await i._collect(s),i.size=i.ranged?Number(o[1]):i.head.length,i}async read(t,e){if(e<=this.head.length)return this.head.subarray(t,e);if(!this.ranged)return this.head.subarray(t,Math.min(e,this.size));let n=await this._ask({Range:`bytes=${t}-${e-1}`});if(n.status!==206)throw new yt(`${this.name}: the server forgot about ranges`);return this._collect(n)}async _ask(t){let e;try{e=await fetch(this.url,{headers:t,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let i=new URL(this.url,location.href).protocol==="file:";throw new yt(i?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!e.ok&&e.status!==416)throw new yt(`cannot load ${this.url}: HTTP ${e.status}`);return e}async _collect(t){if(t.status===416||!t.body)return new Uint8Array;let e=[],n=0,i=t.body.getReader();for(;;){let{done:a,value:c}=await i.read();if(a)break;e.push(c),n+=c.length,this.fetched+=c.length,this.progress(this.fetched,this.expected)}let s=new Uint8Array(n),o=0;for(let a of e)s.set(a,o),o+=a.length;return s}};function Hp(r){return decodeURIComponent(new URL(r,location.href).pathname.split("/").pop())||r}var El=[1024,512];function Al({rgb:r,width:t,height:e}){({rgb:r,width:t,height:e}=Wp({rgb:r,width:t,height:e}));let i=new Float32Array(4*t*e),s=new Float32Array(e),o=[0,0,0],a=0,c=1e-4*Vp(r)+1e-20;for(let l=0;l<e;l++){let u=Math.PI*(l+.5)/e,f=2*Math.PI**2*Math.sin(u)/(t*e),p=0;for(let m=0;m<t;m++){let _=l*t+m;for(let v=0;v<3;v++)i[4*_+v]=r[3*_+v],o[v]+=r[3*_+v]*f*Math.max(0,Math.cos(u));p+=Math.max(c,.2126*r[3*_]+.7152*r[3*_+1]+.0722*r[3*_+2]),i[4*_+3]=p}for(let m=0;m<t;m++)i[4*(l*t+m)+3]/=p;a+=p*Math.sin(u),s[l]=a}for(let l=0;l<e;l++)s[l]/=a;return{values:i,marginal:s,width:t,height:e,up:o}}function Vp(r){let t=0;for(let e=0;e<r.length;e++)t+=r[e];return t/r.length}function Wp({rgb:r,width:t,height:e}){let n=Math.max(1,Math.ceil(t/El[0]),Math.ceil(e/El[1]));if(n===1)return{rgb:r,width:t,height:e};let i=Math.ceil(t/n),s=Math.ceil(e/n),o=new Float32Array(3*i*s);for(let a=0;a<s;a++)for(let c=0;c<i;c++){let l=0;for(let u=a*n;u<Math.min(e,(a+1)*n);u++)for(let f=c*n;f<Math.min(t,(c+1)*n);f++,l++)for(let p=0;p<3;p++)o[3*(a*i+c)+p]+=r[3*(u*t+f)+p];for(let u=0;u<3;u++)o[3*(a*i+c)+u]/=l}return{rgb:o,width:i,height:s}}function Tl(r){return{rgb:Float32Array.from({length:96},(n,i)=>r[i%3]),width:8,height:4}}function Rl(){let e=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let i=0;i<64;i++){let s=Math.PI*(i+.5)/64;for(let o=0;o<128;o++){let a=2*Math.PI*((o+.5)/128-.5),c=[Math.sin(s)*Math.sin(a),Math.cos(s),-Math.sin(s)*Math.cos(a)],l=.16+.14*Math.max(0,c[1]);for(let u=0;u<3;u++){let f=l*[.95,1,1.08][u];for(let[p,m,_]of n){let v=(c[0]*p[0]+c[1]*p[1]+c[2]*p[2])/Math.hypot(...p);f+=_[u]*Math.min(1,Math.max(0,(v-m)/.03))}e[3*(i*128+o)+u]=f}}}return{rgb:e,width:128,height:64}}var Xp={studio:["Studio",Rl],white:["White from all sides",()=>Tl([1,1,1])]},$p=[1.06,1,.9],Cs=Math.PI/180,Is=class{constructor(){this.images=new Map(Object.entries(Xp).map(([t,[e,n]])=>[t,{label:e,make:n}])),this.choice="studio",this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:null})}add(t,e){let n=`image-${this.images.size}`;return this.images.set(n,{label:t,make:()=>e}),n}tables(){let t=this.images.get(this.choice);return t.tables??=Al(t.make()),t.tables}lights(){let t=[],e=[0,0,0];for(let{direction:n,irradiance:i}of this.suns??[this._sun()]){if(!i.some(o=>o>0))continue;let s=qp(n,this.rotation*Cs);t.push({kind:"sun",direction:s,colour:i}),i.forEach((o,a)=>{e[a]+=o*Math.max(0,s[1])})}if(this.strength>0){let n=[this.strength,this.strength,this.strength];t.push({kind:"environment",colour:n,angle:this.rotation*Cs}),this.tables().up.forEach((i,s)=>{e[s]+=i*this.strength})}return{lights:t,irradiance:e}}_sun(){let t=this.sunHeight*Cs,e=this.sunAzimuth*Cs;return{direction:[Math.cos(t)*Math.sin(e),Math.sin(t),Math.cos(t)*Math.cos(e)],irradiance:$p.map(n=>n*this.sun)}}};function qp([r,t,e],n){let i=Math.cos(n),s=Math.sin(n),o=Math.hypot(r,t,e);return[(i*r+s*e)/o,t/o,(i*e-s*r)/o]}var Cl=89*Math.PI/180,Ps=class{constructor(){Object.assign(this,{target:new $,azimuth:.6,elevation:.35,distance:1,fov:30})}frame({min:t,max:e},n){let i=new $(...t),s=new $(...e);this.target.addVectors(i,s).multiplyScalar(.5);let o=i.distanceTo(s)/2||1,a=this.fov*Math.PI/360,c=Math.min(a,Math.atan(Math.tan(a)*n));this.distance=.92*o/Math.sin(c),this.size=o}lookFrom(t,e,n){let i=new $(...t).sub(new $(...e));this.target.set(...e),this.distance=i.length(),this.azimuth=Math.atan2(i.x,i.z),this.elevation=Math.asin(i.y/this.distance),n&&(this.fov=n)}get position(){let t=Math.cos(this.elevation);return new $(t*Math.sin(this.azimuth),Math.sin(this.elevation),t*Math.cos(this.azimuth)).multiplyScalar(this.distance).add(this.target)}turn(t,e){this.azimuth+=t,this.elevation=Math.min(Cl,Math.max(-Cl,this.elevation+e))}zoom(t){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*t))}pan(t,e){let{forward:n,side:i,above:s}=this._axes(),o=2*this.distance*Math.tan(this.fov*Math.PI/360);return this.target.addScaledVector(i,t*o).addScaledVector(s,e*o),n}camera(t,e){let{forward:n,side:i,above:s}=this._axes(),o=Math.tan(this.fov*Math.PI/360),a=o*t/e,c=n.clone().addScaledVector(i,-a).addScaledVector(s,o);return{position:this.position.toArray(),corner:c.toArray(),stepX:i.clone().multiplyScalar(2*a/t).toArray(),stepY:s.clone().multiplyScalar(-2*o/e).toArray()}}_axes(){let t=this.target.clone().sub(this.position).normalize(),e=t.clone().cross(new $(0,1,0)).normalize();return{forward:t,side:e,above:e.clone().cross(t)}}};var It=r=>document.getElementById(r);function Ls(r){return r<1e6?`${Math.round(r/1e3)} kB`:`${(r/1e6).toFixed(r<1e7?2:1)} MB`}var Ns=class{constructor(t){this.app=t;let e=(i,s,o)=>It(i).addEventListener(s,a=>o(a.target));e("tier","change",({value:i})=>t.switchTier(i));let n=(i,s)=>{e(i,"input",({valueAsNumber:o})=>this._setLight(s,o,!0)),e(i,"change",({valueAsNumber:o})=>this._setLight(s,o,!1))};n("environment-intensity","strength"),n("sun-intensity","sun"),n("sun-height","sunHeight"),n("rotation","rotation"),e("environment","change",({value:i})=>this._setLight("choice",i,!1)),e("exposure","input",({valueAsNumber:i})=>t.setExposure(i)),e("exposure","change",()=>this.hasGround&&t.changed()),e("ground","change",()=>t.changed()),e("reset","click",()=>t.resetView()),e("screenshot","click",()=>this._save()),e("fullscreen","click",()=>this._fullScreen()),this.showLighting(t.lighting)}_setLight(t,e,n){(t==="sun"||t==="sunHeight")&&(this.app.lighting.suns=null),this.app.lighting[t]=e,this.app.changed(n)}get hasGround(){return It("ground").checked}setGround(t){It("ground").checked=t}showLighting({images:t,choice:e,strength:n,sun:i,sunHeight:s,rotation:o}){let a=[...t].map(([l,{label:u}])=>new Option(u,l,!1,l===e));It("environment").replaceChildren(...a);let c={"environment-intensity":n,"sun-intensity":i,"sun-height":s,rotation:o};for(let[l,u]of Object.entries(c))It(l).value=u}showEngine(t){It("api").textContent=t,It("missing").textContent=t==="WebGL2"?"Without WebGPU the picture takes longer.":""}showPackage({manifest:t,warnings:e=t.warnings,bytesOf:n,...i},{tier:s}){let o=this.app.opened;document.title=`${t.name} \u2013 RNA viewer`,It("name").textContent=t.name,It("tier").replaceChildren(...t.tiers.map(({name:l})=>new Option(l,l,!1,l===s.name)));let{validation:a,cost:c}=s;It("error").textContent=a?`${a.psnr.toFixed(1)} dB, FLIP ${a.flip.toFixed(3)}`:"not recorded",It("cost").textContent=c?`${c.multiplyAdds.toLocaleString("en")} multiply-adds`:"not recorded",It("size").textContent=Ls(o.bytesOf(s.name)),e.length&&this.say(e.join("; "),!0)}showStats({ms:t,rounds:e,scale:n}){It("time").textContent=t?`${t<10?t.toFixed(1):Math.round(t)} ms`:"\u2013",It("rounds").textContent=n===1?String(e):`first look (1/${n})`}showProgress(t,e){if(It("loading").hidden=t===null,t===null)return;let n=It("bar");e?Object.assign(n,{max:Math.max(e,t),value:t}):n.removeAttribute("value"),It("bytes").textContent=e?`${Ls(t)} of ${Ls(Math.max(e,t))}`:Ls(t)}showPoster(t){let e=It("poster");e.src&&URL.revokeObjectURL(e.src),e.hidden=!t,t?e.src=URL.createObjectURL(t):e.removeAttribute("src")}say(t,e=!1){let n=It("notice");n.hidden=!t,n.textContent=t??"",n.classList.toggle("calm",e)}async _save(){let t=document.createElement("a");t.href=URL.createObjectURL(await this.app.screenshot()),t.download=`${this.app.opened?.manifest.name??"rna"}.png`,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e3)}_fullScreen(){document.fullscreenElement?document.exitFullscreen():document.documentElement.requestFullscreen?.()}};var Zn=5*Math.PI/180;function Il(r,t){let e=new Map,n=null;r.addEventListener("pointerdown",s=>{e.set(s.pointerId,{x:s.clientX,y:s.clientY}),Yp(r,s.pointerId),r.classList.add("dragging"),e.size===2?n="two":e.size===1&&(n=s.button===2?"pan":s.altKey||s.shiftKey?"light":"orbit")}),r.addEventListener("pointermove",s=>{let o=e.get(s.pointerId);if(!o)return;let a={x:s.clientX,y:s.clientY},c=a.x-o.x,l=a.y-o.y;n==="two"&&Zp(e,s.pointerId,o,a,t),e.set(s.pointerId,a),!(!c&&!l)&&(n==="orbit"&&t.orbit(-c*.007,l*.007,!0),n==="light"&&t.light(c*.007,-l*.007,!0),n==="pan"&&t.pan(-c/r.clientHeight,l/r.clientHeight,!0))});for(let s of["pointerup","pointercancel"])r.addEventListener(s,o=>{e.delete(o.pointerId)&&(e.size||(n=null,r.classList.remove("dragging"),t.settle()))});r.addEventListener("contextmenu",s=>s.preventDefault()),r.addEventListener("dblclick",()=>t.reset());let i=0;r.addEventListener("wheel",s=>{s.preventDefault();let o=s.deltaMode===0?s.deltaY:s.deltaY*32;t.zoom(Math.exp(Math.min(300,Math.max(-300,o))*.0012),!0),clearTimeout(i),i=setTimeout(()=>t.settle(),200)},{passive:!1}),r.addEventListener("keydown",s=>Jp(s,t))}function Yp(r,t){try{r.setPointerCapture(t)}catch{}}function Zp(r,t,e,n,i){let s=[...r].find(([a])=>a!==t)?.[1];if(!s)return;let o=a=>Math.hypot(a.x-s.x,a.y-s.y)||1;i.zoom(o(e)/o(n),!0),i.light(.5*(n.x-e.x)*.007,-.5*(n.y-e.y)*.007,!0)}function Jp(r,t){if(r.ctrlKey||r.metaKey)return;let e=r.altKey||r.shiftKey?t.light:t.orbit,n={ArrowLeft:()=>e(-Zn,0),ArrowRight:()=>e(Zn,0),ArrowUp:()=>e(0,Zn),ArrowDown:()=>e(0,-Zn),"+":()=>t.zoom(1/1.1),"=":()=>t.zoom(1/1.1),"-":()=>t.zoom(1.1),"[":()=>t.light(-Zn,0),"]":()=>t.light(Zn,0),Home:()=>t.reset()};Object.hasOwn(n,r.key)&&(r.preventDefault(),n[r.key]())}var ro=[.052,.056,.063],Ds=class extends EventTarget{constructor(t,e,n){super(),Object.assign(this,{engine:t,canvas:e,orbit:n}),Object.assign(this,{lights:[],ground:null,exposure:0,rounds:256,generation:0,msPerPixel:.005,shown:null,finest:1,ready:!1,stopped:!1,moving:!1,stats:{ms:0,rounds:0}}),this.wake=null}restart(t=!1){this.moving=t,this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}stop(){return this.stopped=!0,this.pause(),this.wake?.(),this.running}async converged(t=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=t);)await new Promise(e=>this.addEventListener("shown",e,{once:!0}))}show(){this.shown&&this.engine.show({rounds:this.shown.rounds,exposure:2**this.exposure,backdrop:ro})}async _run(){for(;!this.stopped;){let t=this.generation;try{this.ready&&await this._picture(t)}catch(e){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:e})),this.ready=!1}t===this.generation&&!this.stopped&&await new Promise(e=>{this.wake=e})}}async _picture(t){for(let e of this._scales()){let n=e===1&&!this.moving?this.rounds:1;if(!await this._stage(t,e,n)||this.moving)return}}_scales(){let t=this.canvas.width*this.canvas.height*Math.max(1,this.lights.length),e=1;for(;e<16&&t*this.msPerPixel/e**2>110;)e*=2;let n=[e];for(;e>1;)n.push(e=e>4?e/4:1);return n}async _stage(t,e,n){let{engine:i,canvas:s}=this,o=Math.ceil(s.width/e),a=Math.ceil(s.height/e);this.shown=null,i.resize(o,a);let c=this.orbit.camera(o,a);for(let l=0;l<n;l++){let u=performance.now();if(!await this._round(t,c,l,e))return!1;this._present(l+1,e),this._measure(performance.now()-u,o*a,e)}return!0}async _round(t,e,n,i){let{engine:s}=this,o=c=>this._bands(t,c);if(!await o((c,l)=>s.trace(e,n,c,l)))return!1;let a=n===0;for(let[c,l]of this.lights.entries()){let u={...l,ground:this.ground,cameraAt:e.position};if(!await o((f,p)=>s.light(u,n,f,p)))return!1;s.combine({isFirst:a,countsCoverage:c===0}),a=!1,this.hasShown||this._present(1,i)}if(s.emits){if(!await o((c,l)=>s.emission(c,l)))return!1;s.combine({isEmission:!0,isFirst:a})}return!0}async _bands(t,e){let{width:n,height:i}=this.engine.target,s=Math.max(1,Math.min(i,Math.floor(120/(this.msPerPixel*n))));for(let o=0;o<i;o+=s)if(e(o,Math.min(i,o+s)),await this.engine.done(),t!==this.generation||this.stopped||this.engine.lost)return!1;return!0}_present(t,e){this.shown={rounds:t},this.show(),this.hasShown=!0,Object.assign(this.stats,{rounds:t,scale:e}),this.dispatchEvent(new Event("shown"))}_measure(t,e,n){let i=t/(e*Math.max(1,this.lights.length));this.msPerPixel=e<4096?Math.min(this.msPerPixel*4,i):.5*(this.msPerPixel+i),n===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*t:t)}};var Kp=22e5,Us=class{constructor(t){Object.assign(this,{parameters:t,orbit:new Ps,lighting:new Is,opened:null,loading:null}),this.panel=new Ns(this),this.places={view:document.getElementById("view")},new ResizeObserver(()=>this.resize()).observe(this.places.view),this._listenForDrops()}async begin(){this.canvas=document.createElement("canvas"),this.canvas.tabIndex=0,this.places.view.replaceChildren(this.canvas),this.engine=await Ba(this.canvas,this.parameters.get("api")),this.engine.onlost=t=>this._recover(t),this.viewer=new Ds(this.engine,this.canvas,this.orbit),this.parameters.has("rounds")&&(this.viewer.rounds=Number(this.parameters.get("rounds"))),this.viewer.addEventListener("shown",()=>this.panel.showStats(this.viewer.stats)),this.viewer.addEventListener("failed",({error:t})=>this._failed(t)),Il(this.canvas,this._actions()),this.panel.showEngine(this.engine.constructor.label),this.resize()}async open(t){this.loading?.abort();let e=this.loading=new AbortController;try{this.panel.say(null);let n=t instanceof Blob?new Ts(t,t.name):await Rs.open(t,(s,o)=>this.panel.showProgress(s,o),e.signal),i=await As.open(n);if(e.signal.aborted)return;await this._showPoster(i),await this._show(i,this.parameters.get("tier"),!0)}catch(n){!e.signal.aborted&&n.name!=="AbortError"&&this._failed(n)}finally{this.loading===e&&this.panel.showProgress(null)}}async switchTier(t){try{await this._show(this.opened,t,!1)}catch(e){this._failed(e)}finally{this.panel.showProgress(null)}}async openImage(t,e){try{let n=t instanceof Blob?await t.arrayBuffer():await jp(t);this.lighting.choice=this.lighting.add(e,ya(n,e)),this.panel.showLighting(this.lighting),this.changed()}catch(n){this._failed(n)}}changed(t=!1){if(!this.viewer)return;let{lights:e,irradiance:n}=this.lighting.lights();e.some(({kind:i})=>i==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.lights=e,this.viewer.ground=this._ground(n),this.viewer.restart(t)}resetView(){this.lighting.reset(),this.orbit=this.viewer.orbit=Object.assign(this.orbit,{azimuth:.6,elevation:.35,fov:30}),this.box&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),this.sceneView&&this.applyScene(this.sceneView),this.panel.showLighting(this.lighting),this.changed()}applyScene({camera:t,suns:e,environment:n,ground:i,exposure:s}){this.sceneView={camera:t,suns:e,environment:n,ground:i,exposure:s},t&&this.orbit.lookFrom(t.position,t.look_at,t.vertical_fov_deg),e&&(this.lighting.suns=e),n&&(this.lighting.choice=n.key??this.lighting.choice,this.lighting.strength=n.strength??1,this.lighting.rotation=n.rotation_deg??0),i!==void 0&&this.panel.setGround(i),s!==void 0&&this.setExposure(s),this.panel.showLighting(this.lighting),this.changed()}setExposure(t){this.viewer&&(this.viewer.exposure=t,this.viewer.show())}resize(){if(!this.viewer)return;let{clientWidth:t,clientHeight:e}=this.places.view,n=Number(this.parameters.get("dpr"))||Math.min(devicePixelRatio,2),i=Math.min(n,Math.sqrt(Kp/Math.max(1,t*e))),s=Math.max(1,Math.round(t*i)),o=Math.max(1,Math.round(e*i));this.canvas.width===s&&this.canvas.height===o||(Object.assign(this.canvas,{width:s,height:o}),this.viewer.restart())}screenshot(){return this.viewer.show(),new Promise(t=>this.canvas.toBlob(t,"image/png"))}async _show(t,e,n){let i=await t.load(e);t.forget(),n&&(this.viewer.hasShown=!1),this.viewer.pause();let s=n?ua(i.parts):this.arrays;await this.engine.setAsset(s,i.parts),Object.assign(this,{opened:t,shown:i,arrays:s,box:s.box}),n&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),n&&this.sceneView&&this.applyScene(this.sceneView),document.body.classList.add("loaded"),this.panel.showPackage(t,i),this.viewer.stats.ms=0,this.changed(),this.viewer.start(),this.viewer.addEventListener("shown",()=>this.panel.showPoster(null),{once:!0})}async _showPoster(t){try{this.panel.showPoster(await t.posterImage())}catch{}}_ground(t){if(!this.panel.hasGround||!this.box)return null;let{min:e,max:n}=this.box,i=Math.hypot(...n.map((s,o)=>s-e[o]));return{height:e[1]-1e-4*i,x:(e[0]+n[0])/2,z:(e[2]+n[2])/2,size:2*i,colour:ro.map((s,o)=>t[o]>0?s/t[o]/2**this.viewer.exposure:0)}}_actions(){let t=e=>(...n)=>{e(...n),this.viewer.restart(n.at(-1)===!0)};return{orbit:t((e,n)=>this.orbit.turn(e,n)),pan:t((e,n)=>this.orbit.pan(e,n)),zoom:t(e=>this.orbit.zoom(e)),light:(e,n,i)=>{this.lighting.rotation=(this.lighting.rotation+e*180/Math.PI+540)%360-180,this.lighting.sunHeight=Math.min(90,Math.max(-10,this.lighting.sunHeight+n*180/Math.PI)),this.panel.showLighting(this.lighting),this.changed(i===!0)},settle:()=>this.viewer.moving&&this.viewer.restart(),reset:()=>this.resetView()}}_listenForDrops(){let t=document.body;for(let e of["dragenter","dragover"])addEventListener(e,n=>{n.preventDefault(),t.classList.add("dropping")});addEventListener("dragleave",()=>t.classList.remove("dropping")),addEventListener("drop",async e=>{e.preventDefault(),t.classList.remove("dropping");for(let n of[...e.dataTransfer?.files??[]])await this.openFile(n)})}openFile(t){return/\.(hdr|pic|exr)$/i.test(t.name)?this.openImage(t,t.name):this.open(t)}async _recover(t){let{shown:e,arrays:n}=this;this.panel.say(`${t}; starting again`,!0),this.viewer?.stop(),this.uploaded=null;try{let{exposure:i,rounds:s}=this.viewer;await this.begin(),Object.assign(this.viewer,{exposure:i,rounds:s}),e&&(await this.engine.setAsset(n,e.parts),this.changed(),this.viewer.start()),this.panel.say(null)}catch(i){this._failed(i)}}_failed(t){let e=t instanceof pi||t instanceof yt;e||console.error(t),this.panel.say(e?t.message:`this did not work: ${t.message??t}`),this.failures=(this.failures??0)+1}};async function jp(r){let t=await fetch(r).catch(()=>null);if(!t?.ok)throw new yt(`cannot load ${r}${t?`: HTTP ${t.status}`:""}`);return t.arrayBuffer()}async function Qp(){let r=new URLSearchParams(location.search);document.body.classList.toggle("bare",r.get("ui")==="0");let t=globalThis.rnaViewer=new Us(r);try{await t.begin()}catch(s){t._failed(s);return}let e=r.get("scene"),{asset:n,env:i}=Object.fromEntries(r);if(e){let o=await(await fetch(e)).json();t.applyScene(o),n??=o.asset}i&&await t.openImage(i,i.split("/").pop()),n&&await t.open(n)}Qp();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
