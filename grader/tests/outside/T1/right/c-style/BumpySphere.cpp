#include <raytracer/geometry/BumpySphere.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#define DOT(a,b) ((a)[0]*(b)[0]+(a)[1]*(b)[1]+(a)[2]*(b)[2])
#define LOOP for(i=0;i<3;i++)
using namespace raytracer;
static void cross(const double a[3], const double b[3], double o[3])
{ o[0]=a[1]*b[2]-a[2]*b[1]; o[1]=a[2]*b[0]-a[0]*b[2]; o[2]=a[0]*b[1]-a[1]*b[0]; }
Vector3 raytracer::BumpySphere::getNormalAt(const Vector3 &pos) const
{
	double n[3]={pos.x-centre().x,pos.y-centre().y,pos.z-centre().z},up[3]={0,1,0},t[3],b[3],l,bu,bv;
	int i,x,y,w=heightMap().width(),h=heightMap().height();
	l=sqrt(DOT(n,n)); LOOP n[i]/=l;
	cross(n,up,t);            /* to the right, seen from outside */
	l=sqrt(DOT(t,t)); if(l<1e-9) goto done;
	LOOP t[i]/=l;
	cross(n,t,b);
	if(b[1]>0) LOOP b[i]=-b[i];
	x=(int)((atan2(n[0],-n[2])+M_PI)/(2*M_PI)*w); if(x>=w) x=0;
	y=(int)(acos(n[1])/M_PI*h); if(y>=h) y=h-1;
	if(t[0]*(-n[2])+t[2]*n[0]<0) LOOP t[i]=-t[i];
	bu=heightMap().at(x==w-1?0:x+1,y)-heightMap().at(x,y);
	bv=y==h-1?0:heightMap().at(x,y+1)-heightMap().at(x,y);
	LOOP n[i]-=bu*t[i]+bv*b[i];
	l=sqrt(DOT(n,n)); LOOP n[i]/=l;
done:
	return Vector3(n[0],n[1],n[2]);
}
